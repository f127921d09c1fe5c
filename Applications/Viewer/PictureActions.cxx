#include "PictureActions.h"

#include "MainWindow.h"
#include "OffscreenView.h"
#include "OutputFile.h"
#include "Picture.h"
#include "PictureImage.h"
#include "RenderingError.h"
#include "SceneDocument.h"
#include "SceneRendering.h"
#include "SizeDialog.h"
#include "VolumeView.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QProgressDialog>

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkImageExtractComponents.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkRenderer.h>

#include <exception>
#include <iomanip>
#include <optional>
#include <sstream>

namespace penumbra
{
namespace
{
constexpr int FramesOfTurntable = 72;
constexpr int VideoRate = 24;

// Draws the scene as it is seen now, apart from the view.
class Drawing
{
public:
  explicit Drawing(MainWindow* window)
    : Scene(window->GetDocument()->GetScene())
  {
    this->Scene.Camera = window->GetView()->GetCamera();
    this->Rendering.emplace(this->Scene, window->GetDocument()->GetVoxels());
    this->View.SetRendering(&*this->Rendering);
  }

  ~Drawing() { this->View.SetRendering(nullptr); }

  vtkSmartPointer<vtkImageData> Take(const std::array<int, 2>& size)
  {
    return this->View.TakePicture(size);
  }

  void Turn(double degrees) { this->Rendering->GetRenderer()->GetActiveCamera()->Azimuth(degrees); }

private:
  SceneDescription Scene;
  std::optional<SceneRendering> Rendering;
  OffscreenView View;
};

std::filesystem::path NumberedFile(const std::filesystem::path& file, int number)
{
  std::ostringstream name;
  name << std::setw(4) << std::setfill('0') << number << ".png";
  std::filesystem::path numbered = file;
  numbered.replace_extension();
  numbered += name.str();
  return numbered;
}

void WritePng(const std::filesystem::path& file, vtkImageData* picture)
{
  OutputFile output("picture", file);
  output.Write(EncodePicture(picture, PictureFormat::Png));
  output.Commit();
}

// A video that grows by a picture at a time; a series of PNG files where it is none.
class Turntable
{
public:
  explicit Turntable(const std::filesystem::path& file)
    : File(file)
    , IsVideo(file.extension() == ".ogv")
  {
    if (this->IsVideo)
    {
      this->Video->SetInputConnection(this->Colors->GetOutputPort());
      this->Video->SetFileName(file.u8string().c_str());
      this->Video->SetRate(VideoRate);
      this->Colors->SetComponents(0, 1, 2);
    }
  }

  ~Turntable()
  {
    if (this->IsVideo && this->Count > 0)
    {
      this->Video->End();
    }
  }

  void Add(vtkImageData* picture)
  {
    if (!this->IsVideo)
    {
      WritePng(NumberedFile(this->File, this->Count++), picture);
      return;
    }
    this->Colors->SetInputData(picture);
    if (this->Count++ == 0)
    {
      this->Video->Start();
    }
    this->Video->Write();
    if (this->Video->GetError() != 0)
    {
      throw RenderingError(this->File.u8string() + ": the video cannot be written there");
    }
  }

  int GetCount() const { return this->Count; }

private:
  std::filesystem::path File;
  bool IsVideo;
  int Count = 0;
  vtkNew<vtkImageExtractComponents> Colors;
  vtkNew<vtkOggTheoraWriter> Video;
};
}

//------------------------------------------------------------------------------
PictureActions::PictureActions(MainWindow* window)
  : QObject(window)
  , Window(window)
{
}

//------------------------------------------------------------------------------
void PictureActions::Fill(QMenu* fileMenu, QMenu* editMenu)
{
  QAction* picture = fileMenu->addAction(tr("Save &picture..."));
  picture->setShortcut(tr("Ctrl+P"));
  picture->setToolTip(tr("A picture of the scene in any size"));
  QAction* turntable = fileMenu->addAction(tr("Save &turntable..."));
  turntable->setToolTip(tr("The camera once around, as PNG pictures or a video"));
  QAction* copy = editMenu->addAction(tr("&Copy picture"));
  copy->setShortcut(QKeySequence::Copy);
  copy->setToolTip(tr("The view's picture for other programs"));
  this->connect(picture, &QAction::triggered, this, &PictureActions::AskForPicture);
  this->connect(turntable, &QAction::triggered, this, &PictureActions::AskForTurntable);
  this->connect(copy, &QAction::triggered, this, &PictureActions::Copy);
  SceneDocument* document = this->Window->GetDocument();
  for (QAction* action : { picture, turntable, copy })
  {
    action->setEnabled(false);
    this->connect(document, &SceneDocument::opened, action, [=] { action->setEnabled(true); });
  }
}

//------------------------------------------------------------------------------
QImage PictureActions::Draw(const std::array<int, 2>& size)
{
  return ToQImage(Drawing(this->Window).Take(size));
}

//------------------------------------------------------------------------------
void PictureActions::SavePicture(const std::filesystem::path& file, const std::array<int, 2>& size)
{
  WritePng(file, Drawing(this->Window).Take(size));
}

//------------------------------------------------------------------------------
int PictureActions::SaveTurntable(
  const std::filesystem::path& file, const std::array<int, 2>& size, int frames)
{
  QProgressDialog progress(tr("Drawing the turntable"), tr("Cancel"), 0, frames, this->Window);
  progress.setWindowModality(Qt::WindowModal);
  Drawing drawing(this->Window);
  Turntable turntable(file);
  while (turntable.GetCount() < frames && !progress.wasCanceled())
  {
    turntable.Add(drawing.Take(size));
    drawing.Turn(360.0 / frames);
    progress.setValue(turntable.GetCount());
  }
  return turntable.GetCount();
}

//------------------------------------------------------------------------------
void PictureActions::Copy()
{
  QApplication::clipboard()->setImage(ToQImage(this->Window->GetView()->TakePicture()));
}

//------------------------------------------------------------------------------
void PictureActions::AskForPicture()
{
  SizeDialog dialog(
    tr("Size of the picture"), this->Window->GetView()->GetPictureSize(), this->Window);
  if (dialog.exec() == QDialog::Rejected)
  {
    return;
  }
  QString file = QFileDialog::getSaveFileName(
    this->Window, tr("Save the picture"), QString(), tr("Pictures (*.png)"));
  if (file.isEmpty())
  {
    return;
  }
  file += file.endsWith(".png", Qt::CaseInsensitive) ? "" : ".png";
  try
  {
    this->SavePicture(std::filesystem::u8path(file.toStdString()), dialog.GetSize());
  }
  catch (const std::exception& error)
  {
    this->Window->ShowError(QString::fromUtf8(error.what()));
  }
}

//------------------------------------------------------------------------------
void PictureActions::AskForTurntable()
{
  SizeDialog dialog(tr("Turntable"), this->Window->GetView()->GetPictureSize(), this->Window);
  dialog.AddNumber(tr("Pictures for one turn"), FramesOfTurntable, 2, 10000);
  if (dialog.exec() == QDialog::Rejected)
  {
    return;
  }
  const QString series = tr("PNG pictures (*.png)");
  QString kind = series;
  QString file = QFileDialog::getSaveFileName(
    this->Window, tr("Save the turntable"), QString(), series + ";;" + tr("Video (*.ogv)"), &kind);
  if (file.isEmpty())
  {
    return;
  }
  if (QFileInfo(file).suffix().isEmpty())
  {
    file += kind == series ? ".png" : ".ogv";
  }
  try
  {
    this->SaveTurntable(
      std::filesystem::u8path(file.toStdString()), dialog.GetSize(), dialog.GetNumber());
  }
  catch (const std::exception& error)
  {
    this->Window->ShowError(QString::fromUtf8(error.what()));
  }
}

}
