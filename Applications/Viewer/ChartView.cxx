#include "ChartView.h"

#include <QEvent>

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextInteractorStyle.h>
#include <vtkContextScene.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkPen.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace penumbra
{
namespace
{
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
ChartView::ChartView(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  this->Window->SetMultiSamples(0);
  this->setRenderWindow(this->Window);
  this->Window->AddRenderer(this->Renderer);
  this->Actor->GetScene()->SetRenderer(this->Renderer);
  this->Renderer->AddActor(this->Actor);
  this->Renderer->AddObserver(vtkCommand::StartEvent, this, &ChartView::Arrange);
  vtkNew<vtkContextInteractorStyle> style;
  style->SetScene(this->Actor->GetScene());
  this->interactor()->SetInteractorStyle(style);
}

//------------------------------------------------------------------------------
ChartView::~ChartView()
{
  this->makeCurrent();
  this->Window->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void ChartView::AddChart(vtkChartXY* chart, bool numbered)
{
  Prepare(chart);
  HideAxes(chart);
  if (numbered)
  {
    chart->GetAxis(vtkAxis::BOTTOM)->SetTicksVisible(true);
    chart->GetAxis(vtkAxis::BOTTOM)->SetLabelsVisible(true);
    this->Numbered.push_back(chart);
  }
  this->Actor->GetScene()->AddItem(chart);
  this->ApplyTheme();
}

//------------------------------------------------------------------------------
void ChartView::Arrange()
{
  const int* size = this->Window->GetSize();
  this->ArrangeCharts(static_cast<float>(size[0]), static_cast<float>(size[1]),
    static_cast<float>(this->devicePixelRatioF()));
}

//------------------------------------------------------------------------------
void ChartView::Draw()
{
  this->Outdated = !this->isVisible();
  if (!this->Outdated && this->isValid())
  {
    this->Window->Render();
  }
}

//------------------------------------------------------------------------------
void ChartView::showEvent(QShowEvent* event)
{
  QVTKOpenGLNativeWidget::showEvent(event);
  if (this->Outdated)
  {
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void ChartView::ApplyTheme()
{
  const QColor back = this->palette().color(QPalette::Base);
  const QColor text = this->palette().color(QPalette::Text);
  this->Renderer->SetBackground(back.redF(), back.greenF(), back.blueF());
  for (vtkChartXY* chart : this->Numbered)
  {
    vtkAxis* axis = chart->GetAxis(vtkAxis::BOTTOM);
    axis->GetLabelProperties()->SetColor(text.redF(), text.greenF(), text.blueF());
    axis->GetPen()->SetColorF(text.redF(), text.greenF(), text.blueF());
  }
}

//------------------------------------------------------------------------------
void ChartView::changeEvent(QEvent* event)
{
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
  {
    this->ApplyTheme();
    this->Draw();
  }
}

}
