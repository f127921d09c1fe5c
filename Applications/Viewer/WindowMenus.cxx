#include "WindowMenus.h"

#include "AboutDialog.h"
#include "FileActions.h"
#include "LightPanel.h"
#include "PictureActions.h"
#include "SceneDocument.h"
#include "ViewActions.h"
#include "ViewHandles.h"
#include "VolumeView.h"
#include "WindowPanels.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStyle>
#include <QToolBar>
#include <QToolButton>

namespace penumbra
{
namespace
{
void FillLightMenu(QMenu* menu, const WindowParts& parts)
{
  LightPanel* lights = parts.Panels->GetLights();
  QMenu* add = menu->addMenu(QObject::tr("&Add"));
  add->addActions(lights->GetAddActions());
  menu->addAction(lights->GetCopyAction());
  menu->addAction(lights->GetRemoveAction());
  menu->addSeparator();
  QMenu* rigs = menu->addMenu(QObject::tr("R&igs"));
  rigs->addActions(lights->GetRigActions());
  menu->addAction(lights->GetResetAction());
  menu->addSeparator();
  menu->addAction(parts.Handles->GetLightAction());
}

void FillEditMenu(QMenu* menu, QToolBar* bar, QUndoStack* history)
{
  QAction* undo = history->createUndoAction(menu, QObject::tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setObjectName("undo");
  undo->setIcon(menu->style()->standardIcon(QStyle::SP_ArrowBack));
  QAction* redo = history->createRedoAction(menu, QObject::tr("&Redo"));
  redo->setShortcuts({ QKeySequence::Redo, QKeySequence(QObject::tr("Ctrl+Y")) });
  redo->setObjectName("redo");
  redo->setIcon(menu->style()->standardIcon(QStyle::SP_ArrowForward));
  menu->addActions({ undo, redo });
  bar->addActions({ undo, redo });
  for (QAction* action : { undo, redo }) // whose texts change with every edit
  {
    static_cast<QToolButton*>(bar->widgetForAction(action))
      ->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
}
}

//------------------------------------------------------------------------------
void FillMenus(QMainWindow* window, const WindowParts& parts)
{
  QToolBar* bar = window->addToolBar(QObject::tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  QMenu* file = window->menuBar()->addMenu(QObject::tr("&File"));
  parts.Files->Fill(file, bar);
  bar->addSeparator();
  QMenu* edit = window->menuBar()->addMenu(QObject::tr("&Edit"));
  FillEditMenu(edit, bar, parts.Document->GetHistory());
  parts.Pictures->Fill(file, edit);
  file->addSeparator();
  file->addAction(QObject::tr("&Quit"), window, &QWidget::close, QKeySequence::Quit);
  bar->addSeparator();
  QMenu* view = window->menuBar()->addMenu(QObject::tr("&View"));
  (new ViewActions(parts.Document, parts.View, window))->Fill(view, bar);
  view->addAction(parts.Handles->GetClippingAction());
  QMenu* panels = view->addMenu(QObject::tr("Pa&nels"));
  for (QDockWidget* dock : parts.Panels->GetDocks())
  {
    panels->addAction(dock->toggleViewAction());
  }
  FillLightMenu(window->menuBar()->addMenu(QObject::tr("&Lights")), parts);
  QMenu* help = window->menuBar()->addMenu(QObject::tr("&Help"));
  help->addAction(
    QObject::tr("Mouse and &keys"), window, [window] { ShowKeys(window); }, QObject::tr("F1"));
  help->addAction(QObject::tr("&About Penumbra"), window,
    [window, view = parts.View] { ShowAbout(window, view->renderWindow()); });
  for (QMenu* menu : window->menuBar()->findChildren<QMenu*>())
  {
    menu->setToolTipsVisible(true);
  }
}

}
