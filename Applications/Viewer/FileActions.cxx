#include "FileActions.h"

#include "MainWindow.h"
#include "RecentFiles.h"
#include "SceneDocument.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QStyle>
#include <QToolBar>

#include <exception>

namespace penumbra
{
namespace
{
constexpr const char* FolderKey = "lastFolder";

QString VolumeFilter()
{
  return QObject::tr(
    "Volumes and scenes (*.dcm *.mhd *.mha *.nrrd *.nhdr *.nii *.nii.gz *.vti *.raw "
    "*.json DICOMDIR);;All files (*)");
}

QString SceneFilter()
{
  return QObject::tr("Scenes (*.json)");
}
}

//------------------------------------------------------------------------------
FileActions::FileActions(MainWindow* window, RecentFiles* recent)
  : QObject(window)
  , Window(window)
  , Recent(recent)
{
}

//------------------------------------------------------------------------------
QAction* FileActions::Add(QMenu* menu, const QString& text, const QKeySequence& keys,
  const QString& tip, const std::function<void()>& task)
{
  QAction* action = menu->addAction(text);
  action->setShortcut(keys);
  action->setToolTip(tip);
  action->setStatusTip(tip);
  this->connect(action, &QAction::triggered, this, task);
  return action;
}

//------------------------------------------------------------------------------
void FileActions::Fill(QMenu* menu, QToolBar* bar)
{
  const QStyle* style = this->Window->style();
  QAction* open = this->Add(menu, tr("&Open..."), QKeySequence::Open,
    tr("Open a volume or a scene (Ctrl+O)"), [this] { this->AskForFile(); });
  open->setIcon(style->standardIcon(QStyle::SP_DialogOpenButton));
  QAction* folder = this->Add(menu, tr("Open &DICOM folder..."), tr("Ctrl+Shift+O"),
    tr("Open a folder of DICOM slices (Ctrl+Shift+O)"), [this] { this->AskForFolder(); });
  folder->setIcon(style->standardIcon(QStyle::SP_DirIcon));
  QMenu* recent = menu->addMenu(tr("Open &recent"));
  this->connect(recent, &QMenu::aboutToShow, this, [=] { this->FillRecent(recent); });
  menu->addSeparator();
  this->SaveAction = this->Add(menu, tr("&Save scene"), QKeySequence::Save,
    tr("Save what is seen as a scene that penumbra-render renders too (Ctrl+S)"),
    [this] { this->Save(); });
  this->SaveAction->setIcon(style->standardIcon(QStyle::SP_DialogSaveButton));
  this->SaveAsAction = this->Add(menu, tr("Save scene &as..."), QKeySequence::SaveAs,
    tr("Save what is seen under another name"), [this] { this->SaveAs(); });
  bar->addActions({ open, folder, this->SaveAction });
  this->connect(this->Window->GetDocument(), &SceneDocument::changed, this, &FileActions::Refresh);
  this->Refresh();
}

//------------------------------------------------------------------------------
void FileActions::Refresh()
{
  const bool open = this->Window->GetDocument()->IsOpen();
  this->SaveAction->setEnabled(open);
  this->SaveAsAction->setEnabled(open);
}

//------------------------------------------------------------------------------
QString FileActions::LastFolder() const
{
  return QSettings().value(FolderKey).toString();
}

//------------------------------------------------------------------------------
void FileActions::RememberFolder(const QString& file)
{
  QSettings().setValue(FolderKey, QFileInfo(file).absolutePath());
}

//------------------------------------------------------------------------------
void FileActions::AskForFile()
{
  const QString file = QFileDialog::getOpenFileName(
    this->Window, tr("Open a volume or a scene"), this->LastFolder(), VolumeFilter());
  if (!file.isEmpty())
  {
    this->RememberFolder(file);
    this->Window->OpenAsked(file);
  }
}

//------------------------------------------------------------------------------
void FileActions::AskForFolder()
{
  const QString folder = QFileDialog::getExistingDirectory(
    this->Window, tr("Open a folder of DICOM slices"), this->LastFolder());
  if (!folder.isEmpty())
  {
    this->RememberFolder(folder);
    this->Window->OpenAsked(folder);
  }
}

//------------------------------------------------------------------------------
void FileActions::FillRecent(QMenu* menu)
{
  menu->clear();
  for (const QString& file : this->Recent->Get())
  {
    QAction* action = menu->addAction(QFileInfo(file).fileName());
    action->setToolTip(file);
    action->setStatusTip(file);
    this->connect(action, &QAction::triggered, this, [=] { this->Window->OpenAsked(file); });
  }
  menu->addSeparator();
  menu->addAction(tr("Clear this list"), this->Recent, &RecentFiles::Clear);
}

//------------------------------------------------------------------------------
bool FileActions::Save()
{
  const auto& file = this->Window->GetDocument()->GetSceneFile();
  return file ? this->SaveTo(QString::fromStdString(file->u8string())) : this->SaveAs();
}

//------------------------------------------------------------------------------
bool FileActions::SaveAs()
{
  QString file = QFileDialog::getSaveFileName(
    this->Window, tr("Save the scene"), this->LastFolder(), SceneFilter());
  if (file.isEmpty())
  {
    return false;
  }
  if (QFileInfo(file).suffix().toLower() != "json")
  {
    file += ".json";
  }
  this->RememberFolder(file);
  return this->SaveTo(file);
}

//------------------------------------------------------------------------------
bool FileActions::SaveTo(const QString& file)
{
  try
  {
    this->Window->Save(std::filesystem::u8path(file.toStdString()));
    this->Recent->Add(file);
    return true;
  }
  catch (const std::exception& error)
  {
    this->Window->ShowError(QString::fromUtf8(error.what()));
    return false;
  }
}

//------------------------------------------------------------------------------
bool FileActions::MayDiscardChanges()
{
  const SceneDocument* document = this->Window->GetDocument();
  if (!document->HasUnsavedChanges())
  {
    return true;
  }
  const auto answer = QMessageBox::question(this->Window, tr("Unsaved changes"),
    tr("The scene \"%1\" has changes that are not saved. What is discarded is lost.")
      .arg(document->GetName()),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->Save());
}

}
