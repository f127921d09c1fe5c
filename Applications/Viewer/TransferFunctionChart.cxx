#include "TransferFunctionChart.h"

#include "ColorButton.h"
#include "PresetLook.h"
#include "SceneDocument.h"
#include "VolumeHistogram.h"

#include <QColorDialog>
#include <QMouseEvent>

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkColorTransferControlPointsItem.h>
#include <vtkColorTransferFunction.h>
#include <vtkColorTransferFunctionItem.h>
#include <vtkCompositeTransferFunctionItem.h>
#include <vtkContextActor.h>
#include <vtkContextInteractorStyle.h>
#include <vtkContextMouseEvent.h>
#include <vtkContextScene.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkPen.h>
#include <vtkPiecewiseControlPointsItem.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlotBar.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr float ColorHeight = 26.0f;
constexpr float AxisHeight = 22.0f;
constexpr float Border = 18.0f;

FunctionPoints<1> PointsOf(vtkPiecewiseFunction* function)
{
  FunctionPoints<1> points;
  double node[4];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], std::clamp(node[1], 0.0, 1.0) });
  }
  return points;
}

FunctionPoints<3> PointsOf(vtkColorTransferFunction* function)
{
  FunctionPoints<3> points;
  double node[6];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], std::clamp(node[1], 0.0, 1.0), std::clamp(node[2], 0.0, 1.0),
      std::clamp(node[3], 0.0, 1.0) });
  }
  return points;
}

void Prepare(vtkChartXY* chart)
{
  chart->SetAutoSize(false);
  chart->SetActionToButton(vtkChart::PAN, -1);
  chart->SetActionToButton(vtkChart::ZOOM, -1);
  chart->SetActionToButton(vtkChart::SELECT, -1);
  chart->ZoomWithMouseWheelOff();
  chart->SetForceAxesToBounds(true);
  chart->SetLayoutStrategy(vtkChart::FILL_RECT);
  chart->SetRenderEmpty(true);
  chart->SetHiddenAxisBorder(0);
}

// The plots show the axes that they are added to.
void HideAxes(vtkChartXY* chart)
{
  for (const int side : { vtkAxis::LEFT, vtkAxis::BOTTOM, vtkAxis::RIGHT, vtkAxis::TOP })
  {
    vtkAxis* axis = chart->GetAxis(side);
    axis->SetTitle("");
    axis->SetGridVisible(false);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetAxisVisible(false);
    axis->SetTicksVisible(false);
    axis->SetLabelsVisible(false);
  }
}
}

//------------------------------------------------------------------------------
TransferFunctionChart::TransferFunctionChart(SceneDocument* document, QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Document(document)
{
  this->setObjectName("transferFunctionChart");
  this->setAccessibleName(tr("Transfer function"));
  this->setAccessibleDescription(tr("Opacity and colour over the volume's values"));
  this->setToolTip(
    tr("Click: new point. Drag: move it. Delete: remove it. Double click on a colour "
       "point: its colour. Drag with the right button: move and stretch all."));
  this->setMinimumHeight(150);
  this->Window->SetMultiSamples(0);
  this->setRenderWindow(this->Window);
  this->Window->AddRenderer(this->Renderer);
  this->MakeCharts();
  vtkNew<vtkContextInteractorStyle> style;
  style->SetScene(this->Actor->GetScene());
  this->interactor()->SetInteractorStyle(style);
  this->Opacity->AddObserver(vtkCommand::ModifiedEvent, this, &TransferFunctionChart::TakeOpacity);
  this->Color->AddObserver(vtkCommand::ModifiedEvent, this, &TransferFunctionChart::TakeColor);
  this->Renderer->AddObserver(vtkCommand::StartEvent, this, &TransferFunctionChart::ArrangeCharts);
  this->connect(document, &SceneDocument::opened, this, &TransferFunctionChart::ShowOpened);
  this->connect(document, &SceneDocument::changed, this, &TransferFunctionChart::ShowScene);
  this->ApplyTheme();
}

//------------------------------------------------------------------------------
TransferFunctionChart::~TransferFunctionChart()
{
  this->makeCurrent();
  this->Window->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::MakeCharts()
{
  this->Opacity->AllowDuplicateScalarsOn();
  this->Color->AllowDuplicateScalarsOn();
  Prepare(this->OpacityChart);
  Prepare(this->ColorChart);
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

  HideAxes(this->OpacityChart);
  HideAxes(this->ColorChart);
  this->OpacityChart->GetAxis(vtkAxis::BOTTOM)->SetTicksVisible(true);
  this->OpacityChart->GetAxis(vtkAxis::BOTTOM)->SetLabelsVisible(true);
  this->Actor->GetScene()->AddItem(this->OpacityChart);
  this->Actor->GetScene()->AddItem(this->ColorChart);
  this->Actor->GetScene()->SetRenderer(this->Renderer);
  this->Renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ArrangeCharts()
{
  const auto ratio = static_cast<float>(this->devicePixelRatioF());
  const int* size = this->Window->GetSize();
  const auto width = static_cast<float>(size[0]);
  const auto height = static_cast<float>(size[1]);
  const float border = Border * ratio;
  const float colors = ColorHeight * ratio;
  const float below = border + colors + AxisHeight * ratio;
  this->ColorChart->SetSize({ border, border, width - 2.0f * border, colors });
  this->OpacityChart->SetSize({ border, below, width - 2.0f * border, height - below - border });
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ApplyTheme()
{
  const QColor back = this->palette().color(QPalette::Base);
  const QColor text = this->palette().color(QPalette::Text);
  this->Renderer->SetBackground(back.redF(), back.greenF(), back.blueF());
  vtkAxis* axis = this->OpacityChart->GetAxis(vtkAxis::BOTTOM);
  axis->GetLabelProperties()->SetColor(text.redF(), text.greenF(), text.blueF());
  axis->GetPen()->SetColorF(text.redF(), text.greenF(), text.blueF());
}

//------------------------------------------------------------------------------
void TransferFunctionChart::changeEvent(QEvent* event)
{
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
  {
    this->ApplyTheme();
    this->Window->Render();
  }
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
  if (this->Histogram)
  {
    this->OpacityChart->RemovePlot(0);
  }
  this->Histogram = MakeHistogram(volume);
  vtkNew<vtkPlotBar> bars;
  bars->SetInputData(this->Histogram, 0, 1);
  bars->SetColor(128, 128, 128, 110);
  bars->GetPen()->SetLineType(vtkPen::NO_PEN);
  bars->SetSelectable(false);
  bars->SetInteractive(false);
  this->OpacityChart->AddPlot(bars);
  this->OpacityChart->LowerPlot(bars);
  const double opacityRange[] = { range[0], range[1], 0.0, 1.0 };
  this->OpacityPoints->SetValidBounds(range[0], range[1], 0.0, 1.0);
  this->OpacityPoints->SetUserBounds(
    opacityRange[0], opacityRange[1], opacityRange[2], opacityRange[3]);
  this->ColorPoints->SetUserBounds(range[0], range[1], 0.0, 1.0);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::ShowScene()
{
  const TransferFunctionDescription& function = this->Document->GetScene().TransferFunction;
  this->Showing = true;
  if (PointsOf(this->Opacity) != *function.Opacity)
  {
    this->Opacity->RemoveAllPoints();
    for (const auto& [x, y] : *function.Opacity)
    {
      this->Opacity->AddPoint(x, y);
    }
  }
  if (PointsOf(this->Color) != *function.Color)
  {
    this->Color->RemoveAllPoints();
    for (const auto& [x, red, green, blue] : *function.Color)
    {
      this->Color->AddRGBPoint(x, red, green, blue);
    }
  }
  this->Showing = false;
  if (this->isValid())
  {
    this->Window->Render();
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
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

//------------------------------------------------------------------------------
void TransferFunctionChart::mouseMoveEvent(QMouseEvent* event)
{
  if (!(event->buttons() & Qt::RightButton) || !this->Document->IsOpen())
  {
    QVTKOpenGLNativeWidget::mouseMoveEvent(event);
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
  QVTKOpenGLNativeWidget::mouseDoubleClickEvent(event);
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
