#include "MainWindow.h"

#include "AboutDialog.h"
#include "AppearancePanel.h"
#include "ClippingForm.h"
#include "ClippingHandles.h"
#include "FileActions.h"
#include "InformationPanel.h"
#include "LightHandle.h"
#include "LightPanel.h"
#include "MessageBar.h"
#include "PictureActions.h"
#include "PipelineTree.h"
#include "PropertyForm.h"
#include "RawImportDialog.h"
#include "ReadingProgress.h"
#include "RecentFiles.h"
#include "RenderingForm.h"
#include "SceneDocument.h"
#include "SceneOpening.h"
#include "ScrollableArea.h"
#include "SeriesDialog.h"
#include "StartPage.h"
#include "ViewActions.h"
#include "VolumeView.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QSettings>
#include <QStackedLayout>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

namespace penumbra
{
namespace
{
constexpr int RightWidth = 345;
constexpr int LeftWidth = 240;
constexpr int TreeHeight = 260;
constexpr int InformationHeight = 440;
}

//------------------------------------------------------------------------------
MainWindow::MainWindow(const std::filesystem::path& dicomParser, QWidget* parent)
  : QMainWindow(parent)
  , Document(new SceneDocument(this))
  , Opening(new SceneOpening(dicomParser, this))
  , View(new VolumeView(this->Document, this))
  , Recent(new RecentFiles(this))
  , Files(new FileActions(this, this->Recent))
  , Pictures(new PictureActions(this))
{
  this->setAcceptDrops(true);
  this->MakeMiddle();
  this->MakePanels();
  this->MakeMenus();
  this->Connect();
  this->ShowTitle();
}

//------------------------------------------------------------------------------
MainWindow::~MainWindow()
{
  delete this->Handle; // before the view
  delete this->Clipping;
}

//------------------------------------------------------------------------------
void MainWindow::MakeMiddle()
{
  auto* const middle = new QWidget(this);
  auto* const column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  this->Stack = new QStackedLayout;
  this->Page = new StartPage(middle);
  this->Stack->addWidget(this->Page);
  this->Stack->addWidget(this->View);
  column->addLayout(this->Stack, 1);
  this->Messages = new MessageBar(middle);
  this->setCentralWidget(middle);
  this->Page->ShowRecent(this->Recent->Get());
  this->Progress = new ReadingProgress(this->Opening, this);
  this->statusBar()->addPermanentWidget(this->Progress);
}

//------------------------------------------------------------------------------
QDockWidget* MainWindow::AddPanel(
  const QString& title, const QString& name, Qt::DockWidgetArea area, QWidget* content)
{
  auto* const dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  this->addDockWidget(area, dock);
  return dock;
}

//------------------------------------------------------------------------------
void MainWindow::MakePanels()
{
  auto* const tree = new PipelineTree(this->Document, this);
  QDockWidget* pipeline =
    this->AddPanel(tr("Pipeline"), "pipelineDock", Qt::LeftDockWidgetArea, tree);
  this->Information = new InformationPanel(this->Document, this);
  this->InformationDock = this->AddPanel(tr("Information"), "informationDock",
    Qt::LeftDockWidgetArea, MakeScrollable(this->Information));
  this->Lights = new LightPanel(this->Document, this->View, this);
  this->LightDock =
    this->AddPanel(tr("Lights"), "lightDock", Qt::RightDockWidgetArea, this->Lights);

  this->Appearance = new AppearancePanel(this->Document, this->View, this);
  this->AppearanceDock =
    this->AddPanel(tr("Appearance"), "appearanceDock", Qt::RightDockWidgetArea, this->Appearance);
  auto* const rendering = new PropertyForm(this->Document, this);
  FillRenderingForm(rendering, this->Document, this->View);
  this->Clipping = new ClippingHandles(this->Document, this->View, this);
  this->DragClipping = new QAction(tr("Drag the &clipping in the view"), this);
  this->DragClipping->setObjectName("dragClipping");
  this->DragClipping->setShortcut(tr("C"));
  this->DragClipping->setCheckable(true);
  this->DragClipping->setToolTip(
    tr("The clipping box and planes in the view: drag a ball to cut more or less, an arrow to turn "
       "a plane"));
  this->connect(this->DragClipping, &QAction::toggled, this->Clipping, &ClippingHandles::Show);
  FillClippingForm(rendering, this->Document, this->View, this->DragClipping);
  this->RenderingDock = this->AddPanel(
    tr("Rendering"), "renderingDock", Qt::RightDockWidgetArea, MakeScrollable(rendering));
  rendering->Refresh();
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  this->tabifyDockWidget(this->LightDock, this->AppearanceDock);
  this->tabifyDockWidget(this->AppearanceDock, this->RenderingDock);
  this->LightDock->raise();
  this->resizeDocks(
    { this->InformationDock, this->LightDock }, { LeftWidth, RightWidth }, Qt::Horizontal);
  this->resizeDocks(
    { pipeline, this->InformationDock }, { TreeHeight, InformationHeight }, Qt::Vertical);
  this->Handle = new LightHandle(this->Document, this->View, this);
  this->connect(tree, &PipelineTree::selected, this, &MainWindow::ShowPart);
}

//------------------------------------------------------------------------------
void MainWindow::MakeMenus()
{
  QToolBar* bar = this->addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  QMenu* file = this->menuBar()->addMenu(tr("&File"));
  this->Files->Fill(file, bar);
  bar->addSeparator();
  QMenu* edit = this->menuBar()->addMenu(tr("&Edit"));
  this->MakeEditMenu(edit, bar);
  this->Pictures->Fill(file, edit);
  file->addSeparator();
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);
  bar->addSeparator();
  QMenu* view = this->menuBar()->addMenu(tr("&View"));
  (new ViewActions(this->Document, this->View, this))->Fill(view, bar);
  view->addAction(this->DragClipping);
  QMenu* panels = view->addMenu(tr("Pa&nels"));
  for (QDockWidget* dock : this->findChildren<QDockWidget*>())
  {
    panels->addAction(dock->toggleViewAction());
  }
  QMenu* lights = this->menuBar()->addMenu(tr("&Lights"));
  QMenu* add = lights->addMenu(tr("&Add"));
  add->addActions(this->Lights->GetAddActions());
  lights->addAction(this->Lights->GetCopyAction());
  lights->addAction(this->Lights->GetRemoveAction());
  lights->addSeparator();
  QMenu* rigs = lights->addMenu(tr("R&igs"));
  rigs->addActions(this->Lights->GetRigActions());
  lights->addAction(this->Lights->GetResetAction());
  lights->addSeparator();
  QAction* handle = lights->addAction(tr("&Show the selected light in the view"));
  handle->setObjectName("showLight");
  handle->setShortcut(tr("L"));
  handle->setCheckable(true);
  handle->setToolTip(tr("A ball in the view that can be dragged to move the light"));
  this->connect(handle, &QAction::toggled, this->Handle, &LightHandle::Show);
  QMenu* help = this->menuBar()->addMenu(tr("&Help"));
  help->addAction(
    tr("Mouse and &keys"), this, [this] { ShowKeys(this); }, tr("F1"));
  help->addAction(
    tr("&About Penumbra"), this, [this] { ShowAbout(this, this->View->renderWindow()); });
  for (QMenu* menu : this->menuBar()->findChildren<QMenu*>())
  {
    menu->setToolTipsVisible(true);
  }
}

//------------------------------------------------------------------------------
void MainWindow::MakeEditMenu(QMenu* menu, QToolBar* bar)
{
  QUndoStack* history = this->Document->GetHistory();
  QAction* undo = history->createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setObjectName("undo");
  undo->setIcon(this->style()->standardIcon(QStyle::SP_ArrowBack));
  QAction* redo = history->createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({ QKeySequence::Redo, QKeySequence(tr("Ctrl+Y")) });
  redo->setObjectName("redo");
  redo->setIcon(this->style()->standardIcon(QStyle::SP_ArrowForward));
  menu->addActions({ undo, redo });
  bar->addActions({ undo, redo });
}

//------------------------------------------------------------------------------
void MainWindow::Connect()
{
  const auto ask = [this](void (FileActions::*task)())
  { return [this, task] { (this->Files->*task)(); }; };
  this->connect(this->Page, &StartPage::fileAsked, this, ask(&FileActions::AskForFile));
  this->connect(this->Page, &StartPage::folderAsked, this, ask(&FileActions::AskForFolder));
  this->connect(this->Page, &StartPage::chosen, this, &MainWindow::OpenAsked);
  this->connect(this->Opening, &SceneOpening::opened, this, &MainWindow::ShowOpened);
  this->connect(this->Opening, &SceneOpening::failed, this,
    [this](const QString&, const QString& reason) { this->ShowError(reason); });
  this->connect(this->Opening, &SceneOpening::seriesFound, this, &MainWindow::ChooseSeries);
  this->connect(this->Document, &SceneDocument::refused, this, &MainWindow::ShowError);
  this->connect(this->Document, &SceneDocument::fileChanged, this, &MainWindow::ShowTitle);
  this->connect(
    this->Document->GetHistory(), &QUndoStack::cleanChanged, this, &MainWindow::ShowTitle);
  this->connect(this->View, &VolumeView::aimed, this->Lights, &LightPanel::AimSelected);
  this->connect(this->View, &VolumeView::refined, this,
    [this](double seconds)
    { this->statusBar()->showMessage(tr("Drawn in %1 s").arg(seconds, 0, 'f', 2)); });
}

//------------------------------------------------------------------------------
void MainWindow::Open(const std::filesystem::path& file)
{
  OpenRequest request;
  request.File = file;
  request.ViewSize = this->GetViewSize();
  this->Start(request);
}

//------------------------------------------------------------------------------
std::array<int, 2> MainWindow::GetViewSize() const
{
  const QSize size = this->centralWidget()->size(); // the view's, also before it is shown
  return { size.width(), size.height() };
}

//------------------------------------------------------------------------------
void MainWindow::Start(const OpenRequest& request)
{
  this->Messages->hide();
  this->Opening->Start(request);
  this->Progress->Begin(QString::fromStdString(request.File.filename().u8string()));
}

//------------------------------------------------------------------------------
void MainWindow::OpenAsked(const QString& file)
{
  if (!this->Files->MayDiscardChanges())
  {
    return;
  }
  OpenRequest request;
  request.File = std::filesystem::u8path(file.toStdString());
  request.ViewSize = this->GetViewSize();
  request.AskForSeries = QFileInfo(file).isDir();
  if (QFileInfo(file).suffix().toLower() == "raw")
  {
    RawImportDialog dialog(file, this);
    if (dialog.exec() == QDialog::Rejected)
    {
      return;
    }
    request.Settings = dialog.GetLayout().ToSettings();
  }
  this->Start(request);
}

//------------------------------------------------------------------------------
void MainWindow::ChooseSeries(OpenRequest request, const SeriesChoice& series)
{
  SeriesDialog dialog(series, this);
  if (dialog.exec() == QDialog::Accepted)
  {
    request.AskForSeries = false;
    request.Settings.push_back("volume.series=\"" + dialog.GetChosen().Uid + "\"");
    this->Start(request);
  }
}

//------------------------------------------------------------------------------
void MainWindow::Save(const std::filesystem::path& file)
{
  this->Document->SetView(this->View->GetCamera(), this->View->GetPictureSize());
  this->Document->Save(file);
}

//------------------------------------------------------------------------------
void MainWindow::ShowOpened(const std::shared_ptr<const OpenedScene>& scene)
{
  this->Stack->setCurrentWidget(this->View);
  this->Document->Open(*scene);
  this->Recent->Add(QString::fromStdString(scene->File.u8string()));
  QStringList notes;
  for (const auto* list : { &scene->Choices, &scene->Warnings })
  {
    for (const std::string& note : *list)
    {
      notes << QString::fromStdString(note);
    }
  }
  this->Information->ShowNotes(notes);
  if (!scene->Warnings.empty())
  {
    this->Messages->ShowNotice(QString::fromStdString(scene->Warnings.front()));
  }
  this->View->setFocus();
}

//------------------------------------------------------------------------------
void MainWindow::OfferExample(const std::filesystem::path& scene)
{
  this->Page->SetExample(QString::fromStdString(scene.u8string()));
}

//------------------------------------------------------------------------------
void MainWindow::ShowError(const QString& text)
{
  this->Messages->ShowError(text);
}

//------------------------------------------------------------------------------
void MainWindow::ShowPart(PipelinePart part)
{
  QDockWidget* const docks[] = { this->InformationDock, this->AppearanceDock, this->RenderingDock,
    this->LightDock };
  QDockWidget* dock = docks[static_cast<int>(part)];
  dock->show();
  dock->raise();
}

//------------------------------------------------------------------------------
void MainWindow::ShowTitle()
{
  const std::filesystem::path file =
    this->Document->GetSceneFile().value_or(this->Document->GetOpenedFile());
  const QString name = QString::fromStdString(file.filename().u8string());
  this->setWindowTitle(name.isEmpty() ? QString("Penumbra") : name + "[*]");
  this->setWindowModified(this->Document->HasUnsavedChanges());
}

//------------------------------------------------------------------------------
void MainWindow::RestoreLayout()
{
  const QSettings settings;
  this->restoreGeometry(settings.value("geometry").toByteArray());
  this->restoreState(settings.value("panels").toByteArray());
}

//------------------------------------------------------------------------------
void MainWindow::RememberLayout() const
{
  QSettings settings;
  settings.setValue("geometry", this->saveGeometry());
  settings.setValue("panels", this->saveState());
}

//------------------------------------------------------------------------------
void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->Files->MayDiscardChanges())
  {
    event->ignore();
    return;
  }
  this->RememberLayout();
  QMainWindow::closeEvent(event);
}

//------------------------------------------------------------------------------
void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  const auto urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile())
  {
    event->acceptProposedAction();
  }
}

//------------------------------------------------------------------------------
void MainWindow::dropEvent(QDropEvent* event)
{
  event->acceptProposedAction();
  this->OpenAsked(event->mimeData()->urls().front().toLocalFile());
}

}
