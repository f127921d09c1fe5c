#include "Catch.h"
#include "ClippingSession.h"
#include "ImageComparison.h"

#include <QAction>
#include <QListWidget>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
const Vector3 Center = { 15.5, 15.5, 15.5 };
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
