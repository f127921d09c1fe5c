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
#include <QMainWindow>
#include <QScrollArea>

namespace penumbra
{
namespace
{
constexpr int RightWidth = 345;
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
  this->connect(tree, &PipelineTree::selected, this, &WindowPanels::ShowPart);
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
void WindowPanels::ShowPart(PipelinePart part)
{
  QDockWidget* const docks[] = { this->InformationDock, this->AppearanceDock, this->RenderingDock,
    this->LightDock };
  QDockWidget* dock = docks[static_cast<int>(part)];
  dock->show();
  dock->raise();
}

}
