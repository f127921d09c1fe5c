#include "Catch.h"
#include "ImageComparison.h"
#include "NumberBox.h"
#include "SceneRendering.h"
#include "ViewerSession.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QListWidget>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What a cut that is seen changes at least.
constexpr double Seen = 2.0;
// Voxels that what is dragged may stay behind: motion counts as seen along the axis, which is
// oblique to the view.
constexpr double Behind = 3.0;

struct ClippingSession : ViewerSession
{
  ClippingSession() { REQUIRE(this->Open(this->Files.File)); }

  const SceneDescription& Scene() { return this->Document.GetScene(); }
  void Click(const char* name) { this->Find<QAbstractButton>(name)->click(); }
  void Enter(const char* name, double number) { this->Find<NumberBox>(name)->setValue(number); }

  double ChangeSince(vtkImageData* before)
  {
    return CompareImages(before, this->TakePicture()).rmse;
  }
};

const Vector3 Center = { 15.5, 15.5, 15.5 };
}

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

TEST_CASE("Clipping planes are added, edited, flipped and removed", "[clipping]")
{
  ClippingSession session;
  const auto whole = session.TakePicture();
  auto* const list = session.Find<QListWidget>("planeList");
  CHECK_FALSE(session.Find<QAbstractButton>("removePlane")->isEnabled());
  session.Click("addPlane");
  CHECK(list->count() == 1);
  const auto cut = session.TakePicture();
  CHECK(CompareImages(whole, cut).rmse > Seen);
  session.Click("flipPlane");
  CHECK(session.ChangeSince(cut) > Seen);
  session.Click("addPlane");
  REQUIRE(session.Scene().ClippingPlanes.size() == 2);
  CHECK(session.Document.GetSelectedPlane() == 1);
  session.Enter("Plane through x", 3.0);
  session.Enter("Keeps towards y", 0.5);
  CHECK(session.Scene().ClippingPlanes[1].Origin[0] == 3.0);
  CHECK(session.Scene().ClippingPlanes[1].Normal[1] == 0.5);
  list->setCurrentRow(0);
  session.Enter("Depth of cut", 100.0);
  CHECK(session.Scene().ClippingPlanes[1].Origin[0] == 3.0); // the other one stays
  session.Click("removePlane");
  CHECK(list->count() == 1);
  CHECK(session.Scene().ClippingPlanes[0].Origin[0] == 3.0);
  session.Click("removePlane");
  CHECK_FALSE(session.Find<QAbstractButton>("removePlane")->isEnabled());
  CHECK(session.ChangeSince(whole) == 0.0);
}

TEST_CASE("Clipping planes are pushed and turned in the view", "[clipping]")
{
  ClippingSession session;
  session.Document.Edit("planes",
    [](SceneDescription& scene) {
      scene.ClippingPlanes = { { { 0, 0, 8 }, { 0, 0, 1 } }, { Center, { 1, 0, 0 } } };
    });
  session.Find<QAction>("dragClipping")->setChecked(true);
  session.Document.SelectPlane(1);
  const auto plane = [&](int i) { return session.Scene().ClippingPlanes[i]; };
  session.DragInView(Center, { 22.5, 15.5, 15.5 }); // by its ball
  CHECK(plane(1).Origin[0] == Approx(22.5).margin(Behind));
  CHECK(plane(0).Origin == Vector3{ 0, 0, 8 });
  CHECK(UnitVector(plane(1).Normal)[0] == Approx(1.0));
  const double pushed = plane(1).Origin[0];
  // By its edge on the volume's bounds, which selects it.
  session.Document.SelectPlane(0);
  session.DragInView({ pushed, 0.0, 20.0 }, { pushed - 8.0, 0.0, 20.0 });
  CHECK(plane(1).Origin[0] == Approx(pushed - 8.0).margin(Behind));
  CHECK(session.Document.GetSelectedPlane() == 1);
  session.Document.GetHistory()->setIndex(1);
  CHECK(plane(1).Origin == Center);
  // By the near end of its arrow, which is three tenths of the bounds' diagonal long.
  const double arrow = 0.25 * 31.0 * std::sqrt(3.0);
  session.DragInView({ 15.5 - arrow, 15.5, 15.5 }, { 15.5 - arrow, 15.5, 25.5 });
  CHECK(UnitVector(plane(1).Normal)[2] < -0.2);
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
