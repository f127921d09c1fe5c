#include "VolumeHistogram.h"

#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkImageHistogram.h>
#include <vtkNew.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int NumberOfBins = 256;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeHistogram(vtkImageData* volume)
{
  double range[2];
  volume->GetScalarRange(range);
  const double width = std::max((range[1] - range[0]) / (NumberOfBins - 1), 1e-30);
  vtkNew<vtkImageHistogram> counter;
  counter->SetInputData(volume);
  counter->SetNumberOfBins(NumberOfBins);
  counter->SetBinOrigin(range[0]);
  counter->SetBinSpacing(width);
  counter->GenerateHistogramImageOff();
  counter->Update();
  vtkIdTypeArray* counts = counter->GetHistogram();
  double largest = 1.0;
  for (int bin = 0; bin < NumberOfBins; ++bin)
  {
    largest = std::max(largest, static_cast<double>(counts->GetValue(bin)));
  }
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  vtkNew<vtkFloatArray> heights;
  heights->SetName("frequency");
  for (int bin = 0; bin < NumberOfBins; ++bin)
  {
    values->InsertNextValue(static_cast<float>(range[0] + bin * width));
    heights->InsertNextValue(
      static_cast<float>(std::log1p(counts->GetValue(bin)) / std::log1p(largest)));
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(values);
  table->AddColumn(heights);
  return table;
}

}
