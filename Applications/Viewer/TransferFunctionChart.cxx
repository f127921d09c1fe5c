#include "TransferFunctionChart.h"

#include "ColorButton.h"
#include "FunctionNodes.h"
#include "PresetLook.h"
#include "SceneDocument.h"
#include "VolumeHistogram.h"

#include <QColorDialog>
#include <QMouseEvent>

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkColorTransferControlPointsItem.h>
#include <vtkColorTransferFunction.h>
#include <vtkColorTransferFunctionItem.h>
#include <vtkCompositeTransferFunctionItem.h>
#include <vtkImageData.h>
#include <vtkPiecewiseControlPointsItem.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlot.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr float ColorHeight = 26.0f;
}

//------------------------------------------------------------------------------
TransferFunctionChart::TransferFunctionChart(SceneDocument* document, QWidget* parent)
  : ChartView(parent)
  , Document(document)
{
  this->setObjectName("transferFunctionChart");
  this->setAccessibleName(tr("Transfer function"));
  this->setAccessibleDescription(tr("Opacity and colour over the volume's values"));
  this->setToolTip(
    tr("Click: new point. Drag: move it. Delete: remove it. Double click on a colour "
       "point: its colour. Drag with the right button: move and stretch all."));
  this->setMinimumHeight(150);
  this->MakeCharts();
  this->Opacity->AddObserver(vtkCommand::ModifiedEvent, this, &TransferFunctionChart::TakeOpacity);
  this->Color->AddObserver(vtkCommand::ModifiedEvent, this, &TransferFunctionChart::TakeColor);
  this->connect(document, &SceneDocument::opened, this, &TransferFunctionChart::ShowOpened);
  this->connect(document, &SceneDocument::changed, this, &TransferFunctionChart::ShowScene);
}

//------------------------------------------------------------------------------
TransferFunctionChart::~TransferFunctionChart() = default;

//------------------------------------------------------------------------------
void TransferFunctionChart::MakeCharts()
{
  this->Opacity->AllowDuplicateScalarsOn();
  this->Color->AllowDuplicateScalarsOn();
  vtkNew<vtkCompositeTransferFunctionItem> filled;
  filled->SetColorTransferFunction(this->Color);
  filled->SetOpacityFunction(this->Opacity);
  filled->SetMaskAboveCurve(true);
  this->OpacityChart->AddPlot(filled);
  this->OpacityPoints->SetPiecewiseFunction(this->Opacity);
  this->OpacityPoints->SetEndPointsRemovable(true);
  this->OpacityChart->AddPlot(this->OpacityPoints);

  vtkNew<vtkColorTransferFunctionItem> bar;
  bar->SetColorTransferFunction(this->Color);
  this->ColorChart->AddPlot(bar);
  this->ColorPoints->SetColorTransferFunction(this->Color);
  this->ColorPoints->SetEndPointsRemovable(true);
  this->ColorChart->AddPlot(this->ColorPoints);

  this->AddChart(this->OpacityChart, true);
  this->AddChart(this->ColorChart, false);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ArrangeCharts(float width, float height, float ratio)
{
  const float border = Border * ratio;
  const float colors = ColorHeight * ratio;
  const float below = border + colors + AxisHeight * ratio;
  this->ColorChart->SetSize({ border, border, width - 2.0f * border, colors });
  this->OpacityChart->SetSize({ border, below, width - 2.0f * border, height - below - border });
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ShowOpened()
{
  vtkImageData* volume = this->Document->GetVoxels().Volume;
  double range[2];
  volume->GetScalarRange(range);
  range[1] = range[1] > range[0] ? range[1] : range[0] + 1.0;
  for (vtkChartXY* chart : { this->OpacityChart.Get(), this->ColorChart.Get() })
  {
    chart->GetAxis(vtkAxis::BOTTOM)->SetRange(range);
    chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, 1.0);
  }
  this->OpacityChart->RemovePlotInstance(this->Histogram);
  this->Histogram = AddHistogram(MakeHistogram(volume), this->OpacityChart);
  this->OpacityPoints->SetValidBounds(range[0], range[1], 0.0, 1.0);
  this->OpacityPoints->SetUserBounds(range[0], range[1], 0.0, 1.0);
  this->ColorPoints->SetUserBounds(range[0], range[1], 0.0, 1.0);
  this->Draw();
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ShowScene()
{
  const TransferFunctionDescription& function = this->Document->GetScene().TransferFunction;
  const auto changes = [this] { return this->Opacity->GetMTime() + this->Color->GetMTime(); };
  const vtkMTimeType before = changes();
  this->Showing = true;
  ShowPoints(*function.Opacity, this->Opacity);
  ShowPoints(*function.Color, this->Color);
  this->Showing = false;
  if (changes() != before)
  {
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void TransferFunctionChart::TakeOpacity()
{
  if (!this->Showing && this->Opacity->GetSize() > 0)
  {
    this->Document->Edit(
      tr("change of opacity"),
      [this](SceneDescription& scene) { scene.TransferFunction.Opacity = PointsOf(this->Opacity); },
      "opacity");
  }
}

//------------------------------------------------------------------------------
void TransferFunctionChart::TakeColor()
{
  if (!this->Showing && this->Color->GetSize() > 0)
  {
    this->Document->Edit(
      tr("change of colour"),
      [this](SceneDescription& scene) { scene.TransferFunction.Color = PointsOf(this->Color); },
      "color");
  }
}

//------------------------------------------------------------------------------
void TransferFunctionChart::mousePressEvent(QMouseEvent* event)
{
  this->LastPlace = event->localPos();
  ChartView::mousePressEvent(event);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::mouseMoveEvent(QMouseEvent* event)
{
  if (!(event->buttons() & Qt::RightButton) || !this->Document->IsOpen())
  {
    ChartView::mouseMoveEvent(event);
    return;
  }
  const QPointF moved = event->localPos() - this->LastPlace;
  this->LastPlace = event->localPos();
  double range[2];
  this->OpacityChart->GetAxis(vtkAxis::BOTTOM)->GetRange(range);
  const double shift = moved.x() / this->width() * (range[1] - range[0]);
  const double factor = std::exp(-moved.y() / this->height());
  this->Document->Edit(
    tr("window and level"),
    [=](SceneDescription& scene)
    {
      const auto& points = *scene.TransferFunction.Opacity;
      const double center = 0.5 * (points.front()[0] + points.back()[0]);
      ShiftAndStretch(scene.TransferFunction, shift, factor, center);
    },
    "window");
}

//------------------------------------------------------------------------------
void TransferFunctionChart::mouseDoubleClickEvent(QMouseEvent* event)
{
  ChartView::mouseDoubleClickEvent(event);
  if (event->localPos().y() > this->height() - ColorHeight - Border - AxisHeight / 2.0)
  {
    this->ChooseColor();
  }
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ChooseColor()
{
  const vtkIdType point = this->ColorPoints->GetCurrentPoint();
  if (point < 0 || point >= this->Color->GetSize())
  {
    return;
  }
  double node[6];
  this->Color->GetNodeValue(static_cast<int>(point), node);
  const QColor chosen = QColorDialog::getColor(
    ToQColor({ node[1], node[2], node[3] }), this, tr("Colour at %1").arg(node[0]));
  if (chosen.isValid())
  {
    const Vector3 color = FromQColor(chosen);
    std::copy(color.begin(), color.end(), node + 1);
    this->Color->SetNodeValue(static_cast<int>(point), node);
  }
}

}
