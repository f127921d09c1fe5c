#include "Catch.h"
#include "ImageComparison.h"
#include "MovingSettings.h"
#include "Picture.h"
#include "SceneRendering.h"
#include "ViewDecorations.h"
#include "ViewQuality.h"
#include "ViewerSession.h"

#include <QApplication>
#include <QKeyEvent>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkImageHistogramStatistics.h>
#include <vtkNew.h>

#include <cmath>

using namespace penumbra;

namespace
{
double MeanOf(vtkImageData* picture)
{
  vtkNew<vtkImageHistogramStatistics> statistics;
  statistics->SetInputData(picture);
  statistics->Update();
  return statistics->GetMean();
}

// Whole pictures take too long to be drawn while something moves.
struct SlowScene : ViewerSession
{
  explicit SlowScene(LightFrame frame)
  {
    REQUIRE(this->Open(this->Files.File));
    this->Document.Edit("edit",
      [=](SceneDescription& scene)
      {
        scene.SampleDistance = 0.05;
        scene.Shadows.Technique = TechniqueChoice::Volume;
        scene.Lights[0].Frame = frame;
      });
    VolumeView* view = this->Window.GetView();
    REQUIRE(WaitFor([view] { return view->IsRefined(); }));
  }

  vtkIlluminatedVolumeMapper* GetMapper()
  {
    return this->Window.GetView()->GetRendering()->GetIlluminatedMapper();
  }

  void TurnByKey()
  {
    bool moved = false;
    const auto connection = QObject::connect(
      this->Window.GetView(), &VolumeView::cameraMoved, [&moved] { moved = true; });
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
    QApplication::sendEvent(this->Window.GetView(), &key);
    REQUIRE(WaitFor([&] { return moved; }));
    QObject::disconnect(connection);
  }
};
}

TEST_CASE("The distance between rays follows from the time that rays took", "[moving]")
{
  ViewQuality quality;
  CHECK(quality.FindDistance(10.0) == 1);
  quality.NoteFrame(0.4, 0.0, 2);
  CHECK(quality.GetSecondsOfWholeFrame() == Approx(1.6));
  CHECK(quality.FindDistance(10.0) == 4);
  CHECK(quality.FindDistance(1.0) == 2);
  quality.NoteFrame(0.45, 0.05, 2); // leaves half of a tenth of a second
  CHECK(quality.FindDistance(10.0) == 6);
  quality.NoteFrame(0.6, 0.2, 2); // leaves nothing: rays have a quarter
  CHECK(quality.FindDistance(10.0) == 8);
  CHECK(quality.FindDistance(2.0) == 3);
  quality.NoteFrame(1000.0, 0.0, 1);
  CHECK(quality.FindDistance(10.0) == ViewQuality::LargestDistance);
  CHECK(quality.FindDistance(0.0001) == 1); // still: all pixels
  quality.NoteStill(0.4);
  CHECK(quality.FindDistance(10.0) == 2);
  quality.NoteStill(2.0);
  CHECK(quality.FindDistance(10.0) == 2);
  quality.NoteStill(8.0); // takes at least 1 s by now
  CHECK(quality.FindDistance(10.0) == 4);
}

TEST_CASE(
  "What moves is drawn with longer steps and coarse shadows, as bright as it is", "[moving]")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  VolumeView* view = session.Window.GetView();
  const auto whole = view->TakePicture();
  view->GetDecorations()->Hide(true);
  auto* const mapper = view->GetRendering()->GetIlluminatedMapper();
  const auto draw = [&]
  {
    view->renderWindow()->Render();
    return ReadPicture(view->renderWindow());
  };
  mapper->SetShadowResolution(8.0);
  {
    const MovingSettings settings(mapper, true);
    const auto moving = draw();
    CHECK(mapper->GetSampleDistance() == Approx(1.0)); // half a voxel else
    const double across = 32.0 * std::sqrt(3.0);
    CHECK(mapper->GetActualShadowResolution() ==
      Approx(MovingSettings::TexelsOfShadows / across).epsilon(0.02)); // whole texels
    CHECK(mapper->GetShadowBytes() > 0);
    // A grey level is not seen; half of the picture is black.
    CHECK(MeanOf(moving) == Approx(MeanOf(whole)).margin(0.5));
    CHECK(CompareImages(moving, whole).rmse > 0.5);
  }
  CHECK(mapper->GetShadowResolution() == 8.0);
  mapper->SetShadowResolution(1.0);
  CHECK(CompareImages(draw(), whole).rmse == 0.0);
}

TEST_CASE("Shadows of lights that stay are kept while the camera moves", "[moving]")
{
  SlowScene session(LightFrame::Scene);
  auto* const mapper = session.GetMapper();
  const int updates = mapper->GetNumberOfShadowUpdates();
  session.TurnByKey();
  CHECK_FALSE(session.Window.GetView()->IsRefined());
  CHECK(mapper->GetNumberOfShadowUpdates() == updates);
}

TEST_CASE("Shadows of lights that follow the camera are coarse while it moves", "[moving]")
{
  SlowScene session(LightFrame::Camera);
  auto* const mapper = session.GetMapper();
  const std::size_t bytes = mapper->GetShadowBytes();
  session.TurnByKey();
  CHECK_FALSE(session.Window.GetView()->IsRefined());
  CHECK(mapper->GetShadowBytes() != bytes);
  VolumeView* view = session.Window.GetView();
  REQUIRE(WaitFor([view] { return view->IsRefined(); }));
  CHECK(mapper->GetShadowBytes() == bytes);
}
