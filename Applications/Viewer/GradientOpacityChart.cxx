#include "GradientOpacityChart.h"

#include "FunctionNodes.h"
#include "SceneDocument.h"
#include "VolumeHistogram.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkImageData.h>
#include <vtkPen.h>
#include <vtkPiecewiseControlPointsItem.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPiecewiseFunctionItem.h>
#include <vtkPlot.h>
#include <vtkTable.h>

namespace penumbra
{
namespace
{
// Of the volume's range of values: gradients per voxel beyond it are rare in real data.
constexpr double LargestShown = 0.25;
}

//------------------------------------------------------------------------------
double LargestGradientOfChart(vtkImageData* volume)
{
  double range[2];
  volume->GetScalarRange(range);
  return range[1] > range[0] ? LargestShown * (range[1] - range[0]) : 1.0;
}

//------------------------------------------------------------------------------
GradientOpacityChart::GradientOpacityChart(SceneDocument* document, QWidget* parent)
  : ChartView(parent)
  , Document(document)
{
  this->setObjectName("gradientOpacityChart");
  this->setAccessibleName(tr("Gradient opacity"));
  this->setAccessibleDescription(tr("The part of the opacity that stays, over the gradient"));
  this->setToolTip(tr("To the left is matter that is even, to the right edges; the lower a point, "
                      "the more transparent. Click: new point. Drag: move it. Delete: remove it."));
  this->setMinimumHeight(90);
  this->Function->AllowDuplicateScalarsOn();
  vtkNew<vtkPiecewiseFunctionItem> line;
  line->SetPiecewiseFunction(this->Function);
  // A line that is seen on light and on dark, over an area that the bars are seen through.
  line->SetOpacity(0.1);
  line->GetPolyLinePen()->SetLineType(vtkPen::SOLID_LINE);
  line->GetPolyLinePen()->SetColor(61, 142, 208);
  line->GetPolyLinePen()->SetWidth(2.0f);
  this->Chart->AddPlot(line);
  this->Points->SetPiecewiseFunction(this->Function);
  this->Points->SetEndPointsRemovable(true);
  this->Chart->AddPlot(this->Points);
  this->AddChart(this->Chart, true);
  this->Function->AddObserver(vtkCommand::ModifiedEvent, this, &GradientOpacityChart::TakeFunction);
  this->connect(document, &SceneDocument::opened, this, &GradientOpacityChart::ShowOpened);
  this->connect(document, &SceneDocument::changed, this, &GradientOpacityChart::ShowScene);
}

//------------------------------------------------------------------------------
GradientOpacityChart::~GradientOpacityChart() = default;

//------------------------------------------------------------------------------
void GradientOpacityChart::ArrangeCharts(float width, float height, float ratio)
{
  const float border = Border * ratio;
  const float below = border + AxisHeight * ratio;
  this->Chart->SetSize({ border, below, width - 2.0f * border, height - below - border });
}

//------------------------------------------------------------------------------
void GradientOpacityChart::ShowOpened()
{
  const double largest = LargestGradientOfChart(this->Document->GetVoxels().Volume);
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(0.0, largest);
  this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, 1.0);
  this->Points->SetValidBounds(0.0, largest, 0.0, 1.0);
  this->Points->SetUserBounds(0.0, largest, 0.0, 1.0);
  this->Chart->RemovePlotInstance(this->Histogram);
  this->Histogram = nullptr;
  this->ShowHistogram();
}

//------------------------------------------------------------------------------
void GradientOpacityChart::ShowHistogram()
{
  if (this->isVisible() && this->Document->IsOpen() && !this->Histogram)
  {
    vtkImageData* volume = this->Document->GetVoxels().Volume;
    this->Histogram =
      AddHistogram(MakeGradientHistogram(volume, LargestGradientOfChart(volume)), this->Chart);
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void GradientOpacityChart::showEvent(QShowEvent* event)
{
  ChartView::showEvent(event);
  this->ShowHistogram();
}

//------------------------------------------------------------------------------
void GradientOpacityChart::ShowScene()
{
  const auto& points = this->Document->GetScene().TransferFunction.GradientOpacity;
  const vtkMTimeType before = this->Function->GetMTime();
  this->Showing = true;
  ShowPoints(points ? *points : FunctionPoints<1>(), this->Function);
  this->Showing = false;
  if (this->Function->GetMTime() != before)
  {
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void GradientOpacityChart::TakeFunction()
{
  if (!this->Showing && this->Function->GetSize() > 0 &&
    this->Document->GetScene().TransferFunction.GradientOpacity)
  {
    this->Document->Edit(
      tr("change of gradient opacity"),
      [this](SceneDescription& scene)
      { scene.TransferFunction.GradientOpacity = PointsOf(this->Function); },
      "gradientOpacity");
  }
}

}
