#include "Catch.h"
#include "ImageComparison.h"
#include "PictureActions.h"
#include "RenderingError.h"
#include "RunProgram.h"
#include "SurfacePicking.h"
#include "ViewDecorations.h"
#include "ViewerSession.h"

#include <QApplication>
#include <QClipboard>

#include <vtkImageData.h>

using namespace penumbra;

TEST_CASE("A picture of another size is what penumbra-render renders in that size")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const std::string file = session.Files.PathOf("picture.png");
  session.Window.GetPictures()->SavePicture(file, { 200, 130 });
  session.Document.SetView(session.Window.GetView()->GetCamera(), { 200, 130 });
  const std::string saved = session.Files.PathOf("saved.json");
  session.Document.Save(saved);
  const auto rendered = RenderScene(saved, session.Files);
  CHECK(CompareImages(ReadPNG(file), rendered).rmse < 0.5); // of 8-bit rounding
}

TEST_CASE("A picture is copied to the clipboard")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  session.Window.GetPictures()->Copy();
  const QImage image = QApplication::clipboard()->image();
  CHECK(image.width() == session.Window.GetView()->GetPictureSize()[0]);
}

TEST_CASE("A turntable is a series of different pictures, or a video")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  PictureActions* pictures = session.Window.GetPictures();
  CHECK(pictures->SaveTurntable(session.Files.PathOf("turn.png"), { 64, 48 }, 3) == 3);
  const auto first = ReadPNG(session.Files.PathOf("turn0000.png"));
  CHECK(CompareImages(first, ReadPNG(session.Files.PathOf("turn0001.png"))).rmse > 2.0);
  CHECK(pictures->SaveTurntable(session.Files.PathOf("turn.ogv"), { 64, 48 }, 3) == 3);
  CHECK(ReadAll(session.Files.PathOf("turn.ogv")).substr(0, 4) == "OggS");
  CHECK_THROWS_AS(
    pictures->SaveTurntable(session.Files.PathOf("no/turn.ogv"), { 64, 48 }, 3), RenderingError);
}

TEST_CASE("The surface that is seen is found, and nothing beside the volume")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const auto& scene = session.Document.GetScene();
  vtkImageData* volume = session.Document.GetVoxels().Volume;
  // The shells are 12 apart about the centre at 15.5 and opaque around their middles: from above,
  // the first one that is met is around 12 from the centre.
  const auto place = FindSurface(scene, volume, { 15.5, 15.5, 100.0 }, { 0.0, 0.0, -2.0 });
  REQUIRE(place);
  CHECK((*place)[2] == Approx(27.5).margin(3.0));
  CHECK_FALSE(FindSurface(scene, volume, { 100.0, 15.5, 100.0 }, { 0.0, 0.0, -1.0 }));
}

TEST_CASE("Lengths of the scale bar are round")
{
  CHECK(RoundLength(7.0) == 5.0);
  CHECK(RoundLength(43.0) == Approx(20.0));
  CHECK(RoundLength(0.019) == Approx(0.01));
}
