#include "Catch.h"
#include "ImageComparison.h"
#include "Picture.h"
#include "SceneRendering.h"
#include "StillFrame.h"
#include "ViewDecorations.h"
#include "ViewerSession.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QTimer>

#include <vtkExtractVOI.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkVolume.h>

using namespace penumbra;

namespace
{
struct SlowSession : ViewerSession
{
  // Whole pictures take long enough for strips.
  SlowSession()
  {
    REQUIRE(this->Open(this->Files.File));
    this->Document.Edit("edit",
      [](SceneDescription& scene)
      {
        scene.SampleDistance = 0.05;
        scene.Shadows.Technique = TechniqueChoice::Rays;
      });
  }

  // Waits for the whole picture. Returns how long it took by its own account.
  double WaitForPicture()
  {
    double seconds = 0.0;
    const auto connection = QObject::connect(this->Window.GetView(), &VolumeView::refined,
      [&seconds](double passed) { seconds = passed; });
    WaitFor([&] { return seconds > 0.0; });
    QObject::disconnect(connection);
    return seconds;
  }

  vtkSmartPointer<vtkImageData> ReadView()
  {
    return ReadPicture(this->Window.GetView()->renderWindow());
  }
};

// The lower left or right quarter of a picture.
vtkSmartPointer<vtkImageData> LowerQuarter(vtkImageData* picture, bool right)
{
  const int* size = picture->GetDimensions();
  vtkNew<vtkExtractVOI> part;
  part->SetInputData(picture);
  part->SetVOI(right ? size[0] / 2 : 0, right ? size[0] - 1 : size[0] / 2, 0, size[1] / 2, 0, 0);
  part->Update();
  return part->GetOutput();
}
}

TEST_CASE("A frame that is drawn in strips is the whole frame", "[still]")
{
  // Steps so short that a ray takes several draws, too.
  const double step = GENERATE(0.5, 0.1);
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Document.Edit("edit",
    [=](SceneDescription& scene)
    {
      scene.SampleDistance = step;
      scene.Shadows.SampleDistance = step;
      scene.Shadows.Technique = TechniqueChoice::Rays;
    });
  VolumeView* view = session.Window.GetView();
  const auto whole = view->TakePicture();
  SceneRendering* rendering = view->GetRendering();
  CHECK((rendering->GetIlluminatedMapper()->GetNumberOfDraws() > 1) == (step < 0.5));
  view->GetDecorations()->Hide(true);
  rendering->GetVolume()->VisibilityOff(); // so that nothing of the whole frame is left
  view->renderWindow()->Render();
  rendering->GetVolume()->VisibilityOn();
  StillFrame still;
  still.Begin(rendering->GetRenderer(), rendering->GetIlluminatedMapper(), 7);
  int strips = 1;
  while (!still.DrawNext())
  {
    ++strips;
  }
  CHECK(strips == 7);
  CHECK(still.GetSeconds() > 0.0);
  still.DrawOver(); // of which there is nothing: the volume stays as it is
  const auto drawn = ReadPicture(view->renderWindow());
  // A few pixels that several draws gather are rounded to the next level.
  CHECK(CompareImages(drawn, whole).rmse <= (step < 0.5 ? 0.02 : 0.0));
  view->GetDecorations()->Hide(false);
  still.DrawOver();
  still.End();
  const auto over = ReadPicture(view->renderWindow());
  for (const bool right : { false, true }) // the cube, the scale bar
  {
    CAPTURE(right);
    CHECK(CompareImages(LowerQuarter(drawn, right), LowerQuarter(over, right)).rmse > 0.5);
  }
}

TEST_CASE("Events are answered while a slow picture is drawn", "[still]")
{
  SlowSession session;
  session.WaitForPicture(); // its time is known from now on
  QElapsedTimer clock;
  qint64 longest = 0;
  QTimer beat;
  QObject::connect(&beat, &QTimer::timeout,
    [&]
    {
      longest = std::max(longest, clock.elapsed());
      clock.start();
    });
  session.Window.GetView()->ScheduleFrame();
  clock.start();
  beat.start(5);
  const double seconds = session.WaitForPicture();
  longest = std::max(longest, clock.elapsed());
  CAPTURE(seconds, longest);
  REQUIRE(seconds > 0.3);
  CHECK(longest / 1000.0 < seconds / 2.0);
}

TEST_CASE("What happens while a slow picture is drawn is in the next one", "[still]")
{
  SlowSession session;
  session.WaitForPicture();
  const auto before = session.ReadView();
  VolumeView* view = session.Window.GetView();
  const CameraDescription camera = view->GetCamera();
  view->ScheduleFrame();
  REQUIRE(WaitFor([&] { return !view->updatesEnabled(); })); // strips are being drawn
  QKeyEvent key(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
  QApplication::sendEvent(view, &key);
  CHECK(view->updatesEnabled());
  session.WaitForPicture();
  CHECK(CompareImages(before, session.ReadView()).rmse > 2.0);
  view->SetCamera(camera);
  session.WaitForPicture();
  CHECK(CompareImages(before, session.ReadView()).rmse == 0.0);
}
