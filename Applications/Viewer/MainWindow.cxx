#include "MainWindow.h"

#include "FileActions.h"
#include "InformationPanel.h"
#include "LightPanel.h"
#include "MessageBar.h"
#include "PictureActions.h"
#include "RawImportDialog.h"
#include "ReadingProgress.h"
#include "RecentFiles.h"
#include "SceneDocument.h"
#include "SceneOpening.h"
#include "SeriesDialog.h"
#include "StartPage.h"
#include "ViewHandles.h"
#include "VolumeView.h"
#include "WindowMenus.h"
#include "WindowPanels.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QSettings>
#include <QStackedLayout>
#include <QStatusBar>
#include <QVBoxLayout>

namespace penumbra
{
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
  this->Handles = new ViewHandles(this->Document, this->View, this);
  this->Panels =
    new WindowPanels(this, this->Document, this->View, this->Handles->GetClippingAction());
  FillMenus(
    this, { this->Document, this->View, this->Files, this->Pictures, this->Handles, this->Panels });
  this->Connect();
  this->ShowTitle();
}

//------------------------------------------------------------------------------
MainWindow::~MainWindow()
{
  delete this->Handles; // before the view
}

//------------------------------------------------------------------------------
LightPanel* MainWindow::GetLightPanel()
{
  return this->Panels->GetLights();
}

//------------------------------------------------------------------------------
AppearancePanel* MainWindow::GetAppearance()
{
  return this->Panels->GetAppearance();
}

//------------------------------------------------------------------------------
LightHandle* MainWindow::GetLightHandle()
{
  return this->Handles->GetLight();
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
  const QUndoStack* history = this->Document->GetHistory();
  this->connect(history, &QUndoStack::cleanChanged, this, &MainWindow::ShowTitle);
  this->connect(history, &QUndoStack::indexChanged, this, [this] { this->EditedMeanwhile = true; });
  this->connect(
    this->View, &VolumeView::aimed, this->Panels->GetLights(), &LightPanel::AimSelected);
  this->connect(this->View, &VolumeView::refined, this,
    [this](double seconds)
    {
      this->statusBar()->showMessage(tr("Drawn in %1 s. Drag to turn, scroll to zoom, double-click "
                                        "to aim the light there; F1 tells more.")
                                       .arg(seconds, 0, 'f', 2));
    });
}

//------------------------------------------------------------------------------
void MainWindow::Open(const std::filesystem::path& file)
{
  this->EditedMeanwhile = false;
  this->Start(this->MakeRequest(file));
}

//------------------------------------------------------------------------------
OpenRequest MainWindow::MakeRequest(const std::filesystem::path& file) const
{
  OpenRequest request;
  request.File = file.has_filename() ? file : file.parent_path(); // so that a folder has a name
  const QSize size = this->centralWidget()->size(); // the view's, also before it is shown
  request.ViewSize = { size.width(), size.height() };
  return request;
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
  this->EditedMeanwhile = false;
  OpenRequest request = this->MakeRequest(std::filesystem::u8path(file.toStdString()));
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
  if (this->EditedMeanwhile && !this->Files->MayDiscardChanges())
  {
    return;
  }
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
  this->Panels->GetInformation()->ShowNotes(notes);
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
void MainWindow::ShowTitle()
{
  const QString name = this->Document->GetName();
  this->setWindowTitle(name.isEmpty() ? QString("Penumbra") : name + "[*]");
  this->setWindowModified(this->Document->HasUnsavedChanges());
}

//------------------------------------------------------------------------------
void MainWindow::RestoreLayout()
{
  const QSettings settings;
  this->restoreGeometry(settings.value("geometry").toByteArray());
  this->Panels->SetArrangement(settings.value("panels").toByteArray());
}

//------------------------------------------------------------------------------
void MainWindow::RememberLayout() const
{
  QSettings settings;
  settings.setValue("geometry", this->saveGeometry());
  settings.setValue("panels", this->Panels->GetArrangement());
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
