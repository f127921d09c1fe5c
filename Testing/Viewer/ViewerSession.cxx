#include "ViewerSession.h"

#include "Catch.h"
#include "ImageComparison.h"
#include "RunProgram.h"
#include "SceneRendering.h"
#include "SyntheticVolumes.h"

#include <QApplication>
#include <QLineEdit>
#include <QMouseEvent>

#include <vtkImageData.h>
#include <vtkImageExtractComponents.h>
#include <vtkMetaImageWriter.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace penumbra
{

//------------------------------------------------------------------------------
void TypeText(QLineEdit* line, const QString& text)
{
  line->selectAll();
  for (const QChar letter : text)
  {
    QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, letter);
    QApplication::sendEvent(line, &event);
  }
}

//------------------------------------------------------------------------------
ShellsScene::ShellsScene()
{
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetInputData(MakeShells({}, 12.0));
  writer->SetFileName(this->PathOf("shells.mhd").c_str());
  writer->SetRAWFileName(this->PathOf("shells.zraw").c_str());
  writer->Write();
  this->File = this->Write("scene.json", R"({
    "volume": { "file": "shells.mhd" },
    "transferFunction": { "opacity": [[120,0],[200,0.5]],
                          "color": [[120,0.9,0.5,0.3],[255,1,0.9,0.8]] },
    "lights": [{ "name": "key", "type": "directional", "direction": [1,0.6,-1], "shadow": "soft" }],
    "image": { "size": [300,240], "background": [0,0,0] } })");
}

//------------------------------------------------------------------------------
ViewerSession::ViewerSession()
  : Window(PENUMBRA_DICOM_PARSER)
  , Document(*this->Window.GetDocument())
{
  this->Window.resize(900, 640);
  this->Window.show();
  QObject::connect(this->Window.GetOpening(), &SceneOpening::failed, &this->Window,
    [this](const QString&, const QString& reason) { this->Reason = reason.toStdString(); });
}

//------------------------------------------------------------------------------
bool ViewerSession::Open(const std::string& file)
{
  this->Reason.clear();
  bool opened = false;
  const auto connection = QObject::connect(
    &this->Document, &SceneDocument::opened, &this->Window, [&opened] { opened = true; });
  this->Window.Open(file);
  WaitFor([&] { return opened || !this->Reason.empty(); });
  QObject::disconnect(connection);
  return opened && WaitFor([this] { return this->Window.GetView()->IsRefined(); });
}

//------------------------------------------------------------------------------
void ViewerSession::DragInView(const Vector3& from, const Vector3& to)
{
  constexpr int steps = 5;
  VolumeView* view = this->Window.GetView();
  WaitFor([view] { return view->IsRefined(); });
  vtkRenderer* renderer = view->GetRendering()->GetRenderer();
  const auto place = [&](const Vector3& world)
  {
    renderer->SetWorldPoint(world[0], world[1], world[2], 1.0);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    return QPointF(display[0] + 0.5, view->height() - display[1] - 0.5);
  };
  const QPointF start = place(from);
  const QPointF path = place(to) - start;
  const auto send = [view](QEvent::Type type, const QPointF& where, Qt::MouseButtons buttons)
  {
    const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, where, button, buttons, Qt::NoModifier);
    QApplication::sendEvent(view, &event);
    QApplication::processEvents();
  };
  send(QEvent::MouseMove, start, Qt::NoButton);
  send(QEvent::MouseButtonPress, start, Qt::LeftButton);
  for (int i = 1; i <= steps; ++i)
  {
    send(QEvent::MouseMove, start + path * i / steps, Qt::LeftButton);
  }
  send(QEvent::MouseButtonRelease, start + path, Qt::NoButton);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewerSession::TakePicture()
{
  vtkNew<vtkImageExtractComponents> colors;
  colors->SetInputData(this->Window.GetView()->TakePicture());
  colors->SetComponents(0, 1, 2);
  colors->Update();
  return colors->GetOutput();
}

//------------------------------------------------------------------------------
double ViewerSession::ChangeSince(vtkImageData* before)
{
  return CompareImages(before, this->TakePicture()).rmse;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderScene(const std::string& file, const TemporaryFolder& folder)
{
  const std::string picture = folder.PathOf("rendered.png");
  const ProgramResult result = RunPenumbraRender({ file, "--output", picture });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  return ReadPNG(picture);
}

}
