#include "Catch.h"
#include "ImageComparison.h"
#include "ViewerSession.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

using namespace penumbra;

TEST_CASE("The view shows what penumbra-render renders of the saved scene")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const auto picture = session.TakePicture();
  const std::string saved = session.Files.PathOf("saved.json");
  session.Window.Save(saved);
  // Both are the same program on the same data; the rest is how 8-bit colours are rounded.
  CHECK(CompareImages(picture, RenderScene(saved, session.Files)).rmse < 0.5);
}

TEST_CASE("A bad file says what is wrong and leaves what was open")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const auto before = session.TakePicture();
  CHECK_FALSE(session.Open(session.Files.Write("bad.mhd", "NDims = three")));
  CHECK_THAT(session.GetReason(), Catch::Matchers::ContainsSubstring("bad.mhd"));
  CHECK(session.Document.GetOpenedFile() == session.Files.File);
  CHECK(CompareImages(before, session.TakePicture()).largest == 0.0);
}

TEST_CASE("Canceling leaves what was open")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  bool canceled = false;
  QObject::connect(session.Window.GetOpening(), &SceneOpening::canceled, &session.Window,
    [&canceled] { canceled = true; });
  session.Window.Open(session.Files.PathOf("shells.mhd"));
  CHECK(session.Window.GetOpening()->IsReading());
  session.Window.GetOpening()->Cancel();
  CHECK(canceled);
  CHECK_FALSE(session.Window.GetOpening()->IsReading());
  // What was read nevertheless is not shown.
  CHECK_FALSE(WaitFor([&] { return session.Document.GetOpenedFile() != session.Files.File; }, 1.0));
}

TEST_CASE("Facts about the volume are told", "[information]")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const std::string facts =
    session.Find<QLabel>("volumeFacts")->text().remove(QChar(0x2009)).toStdString();
  for (const char* fact : { "File</td><td>shells.mhd<", "Voxels</td><td>32\u00d732\u00d732<",
         "Spacing</td><td>1\u00d71\u00d71<", "Size</td><td>32\u00d732\u00d732<",
         "Type</td><td>uint8<" })
  {
    CHECK_THAT(facts, Catch::Matchers::Contains(fact));
  }
}

TEST_CASE("Of what is opened before the last was read, the last is shown")
{
  ViewerSession session;
  for (int i = 0; i < 5; ++i)
  {
    session.Window.Open(session.Files.PathOf("shells.mhd"));
  }
  int opened = 0;
  QObject::connect(&session.Document, &SceneDocument::opened, &session.Window, [&] { ++opened; });
  REQUIRE(session.Open(session.Files.File));
  CHECK(session.Document.GetOpenedFile() == session.Files.File);
  CHECK_FALSE(WaitFor([&] { return opened > 1; }, 0.5));
}

TEST_CASE("A volume without a scene is lit and shadowed from the start")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.PathOf("shells.mhd")));
  const auto& lights = session.Document.GetScene().Lights;
  CHECK(std::any_of(lights.begin(), lights.end(),
    [](const LightDescription& light) { return light.On && light.Shadow != ShadowKind::None; }));
}

TEST_CASE("The first page is seen until something is open")
{
  ViewerSession session;
  auto* const page = session.Window.findChild<QWidget*>("startPage");
  CHECK(page->isVisible());
  CHECK_FALSE(session.Window.GetView()->isVisible());
  REQUIRE(session.Open(session.Files.File));
  CHECK_FALSE(page->isVisible());
  CHECK(session.Window.GetView()->isVisible());
}

TEST_CASE("Keys turn and zoom the camera, and none of VTK's own is taken")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  VolumeView* view = session.Window.GetView();
  const auto press = [view](int key, const QString& text)
  {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
    QApplication::sendEvent(view, &event);
  };
  const CameraDescription before = view->GetCamera();
  int taken = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&taken);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  for (const auto event : { vtkCommand::KeyPressEvent, vtkCommand::CharEvent })
  {
    view->interactor()->AddObserver(event, count);
  }
  for (const QChar letter : QString("wseqpfrjtau3"))
  {
    press(letter.toUpper().unicode(), letter);
  }
  CHECK(taken == 0); // the interactor hears of none, and so does no style and no widget
  CHECK(view->GetCamera().Position == before.Position);
  const auto distance = [view]
  {
    const ViewFrame frame = view->GetFrame();
    return Length(Difference(frame.Position, frame.FocalPoint));
  };
  const double farAway = distance();
  press(Qt::Key_Plus, "+");
  CHECK(distance() < 0.95 * farAway);
  press(Qt::Key_Minus, "-");
  CHECK(distance() == Approx(farAway));
  press(Qt::Key_Left, "");
  CHECK(Length(Difference(*view->GetCamera().Position, *before.Position)) > 0.01 * farAway);
}
