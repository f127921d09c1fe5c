#include "Catch.h"
#include "ClippingSession.h"
#include "ImageComparison.h"

#include <QAction>

#include <vtkImageData.h>

using namespace penumbra;

TEST_CASE("What the clipping box cuts away is not seen, and a reset brings it back", "[clipping]")
{
  ClippingSession session;
  const auto whole = session.TakePicture();
  session.Click("Clipping box");
  session.Enter("z to", 50.0);
  CHECK((*session.Scene().Volume.Cropping)[5] == Approx(15.5));
  CHECK(session.ChangeSince(whole) > Seen);
  session.Enter("z from", 90.0); // past the other side: some is left
  CHECK((*session.Scene().Volume.Cropping)[4] == Approx(15.5 - 0.005 * 31.0));
  session.Click("resetBox");
  CHECK(session.ChangeSince(whole) == 0.0);
  session.Document.GetHistory()->undo();
  CHECK(session.ChangeSince(whole) > Seen);
  session.Click("Clipping box");
  CHECK_FALSE(session.Scene().Volume.Cropping);
  CHECK(session.ChangeSince(whole) == 0.0);
}

TEST_CASE("A side of the clipping box is dragged in the view by its ball", "[clipping]")
{
  ClippingSession session;
  const auto whole = session.TakePicture();
  session.Click("Clipping box");
  CHECK(session.Find<QAction>("dragClipping")->isChecked());
  CHECK(session.ChangeSince(whole) == 0.0); // pictures of the scene are without the box
  const int before = session.Document.GetHistory()->index();
  session.DragInView({ 31.0, 15.5, 15.5 }, { 20.0, 15.5, 15.5 });
  const auto& box = *session.Scene().Volume.Cropping;
  CHECK(box[1] == Approx(20.0).margin(Behind));
  CHECK(box[0] == 0.0);
  CHECK(box[5] == 31.0);
  CHECK(session.Document.GetHistory()->index() == before + 1); // one drag, one step
  CHECK(session.ChangeSince(whole) > Seen);
  session.DragInView({ box[1], 15.5, 15.5 }, { 60.0, 15.5, 15.5 });
  CHECK((*session.Scene().Volume.Cropping)[1] == 31.0); // not beyond the volume
}

TEST_CASE("The camera turns where nothing of the box or a plane is dragged", "[clipping]")
{
  ClippingSession session;
  session.Click("Clipping box");
  session.Click("addPlane");
  const SceneDescription before = session.Scene();
  const Vector3 eye = *session.Window.GetView()->GetCamera().Position;
  session.DragInView({ 22.0, 15.5, 9.0 }, { 10.0, 15.5, 9.0 });
  CHECK(Length(Difference(eye, *session.Window.GetView()->GetCamera().Position)) > 1.0);
  CHECK(session.Scene().Volume.Cropping == before.Volume.Cropping);
  CHECK(session.Scene().ClippingPlanes[0].Origin == before.ClippingPlanes[0].Origin);
}

TEST_CASE("Box and planes are in the saved scene, which renders to the same picture", "[clipping]")
{
  ClippingSession session;
  session.Click("Clipping box");
  session.Enter("x to", 70.0);
  session.Click("addPlane");
  session.Click("addPlane");
  session.Enter("Keeps towards z", 0.7);
  const auto picture = session.TakePicture();
  const std::string saved = session.Files.PathOf("saved.json");
  session.Window.Save(saved);
  CHECK(CompareImages(picture, RenderScene(saved, session.Files)).rmse < 0.5); // 8-bit rounding
  REQUIRE(session.Open(saved));
  CHECK(session.Scene().ClippingPlanes.size() == 2);
  CHECK(session.Document.GetSelectedPlane() == 0);
}
