#include "WindowPanels.h"

#include "AppearancePanel.h"
#include "ClippingForm.h"
#include "InformationPanel.h"
#include "LightPanel.h"
#include "PipelineTree.h"
#include "PropertyForm.h"
#include "RenderingForm.h"
#include "SceneDocument.h"
#include "ScrollableArea.h"
#include "VolumeView.h"

#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QScrollArea>

namespace penumbra
{
namespace
{
constexpr int RightWidth = 345;
constexpr int ColumnWidth = 380; // for the titles of five tabs
constexpr int NarrowWidth = 1100;
constexpr int LeftWidth = 260;
constexpr int TreeHeight = 260;
constexpr int InformationHeight = 440;
}

//------------------------------------------------------------------------------
WindowPanels::WindowPanels(
  QMainWindow* window, SceneDocument* document, VolumeView* view, QAction* dragClipping)
  : QObject(window)
  , Window(window)
  , Document(document)
  , View(view)
  , Information(new InformationPanel(document, window))
  , Lights(new LightPanel(document, view, window))
  , Appearance(new AppearancePanel(document, view, window))
{
  auto* const tree = new PipelineTree(document, window);
  this->PipelineDock = this->Add(tr("Pipeline"), "pipelineDock", Qt::LeftDockWidgetArea, tree);
  this->InformationDock = this->Add(tr("Information"), "informationDock", Qt::LeftDockWidgetArea,
    MakeScrollable(this->Information));
  this->LightDock = this->Add(tr("Lights"), "lightDock", Qt::RightDockWidgetArea, this->Lights);
  this->AppearanceDock =
    this->Add(tr("Appearance"), "appearanceDock", Qt::RightDockWidgetArea, this->Appearance);
  this->RenderingDock = this->Add(
    tr("Rendering"), "renderingDock", Qt::RightDockWidgetArea, this->MakeRendering(dragClipping));
  this->Arrange();
  this->connect(tree, &PipelineTree::volumeShown, view, &VolumeView::ShowVolume);
  this->connect(tree, &PipelineTree::selected, this, &WindowPanels::ShowSelected);
  this->connect(tree, &PipelineTree::controlsAsked, this, &WindowPanels::Show);
  window->installEventFilter(this);
}

//------------------------------------------------------------------------------
QDockWidget* WindowPanels::Add(
  const QString& title, const QString& name, Qt::DockWidgetArea area, QWidget* content)
{
  auto* const dock = new QDockWidget(title, this->Window);
  dock->setObjectName(name);
  dock->setWidget(content);
  this->Window->addDockWidget(area, dock);
  return dock;
}

//------------------------------------------------------------------------------
QWidget* WindowPanels::MakeRendering(QAction* dragClipping)
{
  auto* const form = new PropertyForm(this->Document, this->Window);
  FillRenderingForm(form, this->Document, this->View);
  FillClippingForm(form, this->Document, this->View, dragClipping);
  form->Refresh();
  return MakeScrollable(form);
}

//------------------------------------------------------------------------------
void WindowPanels::Arrange()
{
  this->Window->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->Window->tabifyDockWidget(this->LightDock, this->AppearanceDock);
  this->Window->tabifyDockWidget(this->AppearanceDock, this->RenderingDock);
  this->LightDock->raise();
  this->Window->resizeDocks(
    { this->InformationDock, this->LightDock }, { LeftWidth, RightWidth }, Qt::Horizontal);
  this->Window->resizeDocks(
    { this->PipelineDock, this->InformationDock }, { TreeHeight, InformationHeight }, Qt::Vertical);
}

//------------------------------------------------------------------------------
QList<QDockWidget*> WindowPanels::GetDocks() const
{
  return { this->PipelineDock, this->InformationDock, this->LightDock, this->AppearanceDock,
    this->RenderingDock };
}

//------------------------------------------------------------------------------
QByteArray WindowPanels::GetArrangement() const
{
  return this->WideArrangement.value_or(this->Window->saveState());
}

//------------------------------------------------------------------------------
void WindowPanels::SetArrangement(const QByteArray& arrangement)
{
  this->WideArrangement.reset();
  this->Window->restoreState(arrangement);
  this->FitWindow();
}

//------------------------------------------------------------------------------
bool WindowPanels::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->FitWindow();
  }
  return QObject::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void WindowPanels::FitWindow()
{
  const bool narrow = this->Window->width() < NarrowWidth;
  if (narrow && !this->WideArrangement)
  {
    this->WideArrangement = this->Window->saveState();
    this->ArrangeInOneColumn();
    this->Window->layout()->activate(); // so that what is opened at once fits the view
  }
  else if (!narrow && this->WideArrangement)
  {
    this->Window->restoreState(*this->WideArrangement);
    this->WideArrangement.reset();
  }
}

//------------------------------------------------------------------------------
void WindowPanels::ArrangeInOneColumn()
{
  QDockWidget* before = nullptr;
  for (QDockWidget* dock : { this->LightDock, this->AppearanceDock, this->RenderingDock,
         this->PipelineDock, this->InformationDock })
  {
    if (dock->isFloating())
    {
      continue;
    }
    this->Window->addDockWidget(Qt::RightDockWidgetArea, dock);
    if (before)
    {
      this->Window->tabifyDockWidget(before, dock);
    }
    before = dock;
  }
  this->LightDock->raise();
  this->Window->resizeDocks({ this->LightDock }, { ColumnWidth }, Qt::Horizontal);
}

//------------------------------------------------------------------------------
QDockWidget* WindowPanels::DockOf(PipelinePart part) const
{
  QDockWidget* const docks[] = { this->InformationDock, this->AppearanceDock, this->RenderingDock,
    this->LightDock };
  return docks[static_cast<int>(part)];
}

//------------------------------------------------------------------------------
void WindowPanels::ShowSelected(PipelinePart part)
{
  // What would cover the tree while one goes through it waits until it is asked for.
  if (!this->Window->tabifiedDockWidgets(this->PipelineDock).contains(this->DockOf(part)))
  {
    this->Show(part);
  }
}

//------------------------------------------------------------------------------
void WindowPanels::Show(PipelinePart part)
{
  QDockWidget* dock = this->DockOf(part);
  dock->show();
  dock->raise();
}

}
