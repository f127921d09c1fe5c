#include "VolumeHistogram.h"

#include <vtkChartXY.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkImageGradientMagnitude.h>
#include <vtkImageHistogram.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int MostBins = 256;

// Bins that are narrower than the steps of whole numbers would make a comb.
double WidthOfBins(double range, vtkImageData* volume)
{
  const int type = volume->GetScalarType();
  const double least = type == VTK_FLOAT || type == VTK_DOUBLE ? 1e-30 : 1.0;
  return std::max(range / (MostBins - 1), least);
}

vtkSmartPointer<vtkTable> Count(vtkImageData* volume, double lowest, double largest)
{
  const double width = WidthOfBins(largest - lowest, volume);
  vtkNew<vtkImageHistogram> counter;
  counter->SetInputData(volume);
  counter->SetNumberOfBins(static_cast<int>((largest - lowest) / width) + 1);
  counter->SetBinOrigin(lowest);
  counter->SetBinSpacing(width);
  counter->GenerateHistogramImageOff();
  counter->Update();
  vtkIdTypeArray* counts = counter->GetHistogram();
  const double most = std::max(counts->GetRange()[1], 1.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  vtkNew<vtkFloatArray> heights;
  heights->SetName("frequency");
  for (vtkIdType bin = 0; bin < counts->GetNumberOfValues(); ++bin)
  {
    values->InsertNextValue(static_cast<float>(lowest + bin * width));
    heights->InsertNextValue(
      static_cast<float>(std::log1p(counts->GetValue(bin)) / std::log1p(most)));
  }
  vtkNew<vtkFloatArray> floor;
  floor->SetName("floor");
  floor->SetNumberOfValues(heights->GetNumberOfValues());
  floor->FillValue(0.0f);
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(values);
  table->AddColumn(heights);
  table->AddColumn(floor);
  return table;
}

// With spacings of 1 in the mean, which makes gradients values per mean voxel.
vtkSmartPointer<vtkImageData> WithMeanSpacingOfOne(vtkImageData* volume)
{
  const double* spacing = volume->GetSpacing();
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  auto scaled = vtkSmartPointer<vtkImageData>::New();
  scaled->ShallowCopy(volume);
  scaled->SetSpacing(spacing[0] / mean, spacing[1] / mean, spacing[2] / mean);
  return scaled;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeHistogram(vtkImageData* volume)
{
  double range[2];
  volume->GetScalarRange(range);
  return Count(volume, range[0], range[1]);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeGradientHistogram(vtkImageData* volume, double largest)
{
  vtkNew<vtkImageGradientMagnitude> gradients;
  gradients->SetInputData(WithMeanSpacingOfOne(volume));
  gradients->SetDimensionality(3);
  gradients->Update();
  return Count(gradients->GetOutput(), 0.0, largest);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPlot> AddHistogram(vtkTable* histogram, vtkChartXY* chart)
{
  auto area = vtkSmartPointer<vtkPlotArea>::New();
  area->SetInputData(histogram);
  area->SetInputArray(0, "value");
  area->SetInputArray(1, "frequency");
  area->SetInputArray(2, "floor");
  area->SetColor(128, 128, 128, 110);
  area->GetPen()->SetLineType(vtkPen::NO_PEN);
  area->SetSelectable(false);
  area->SetInteractive(false);
  chart->AddPlot(area);
  chart->LowerPlot(area);
  return area;
}

}
