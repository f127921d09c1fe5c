#include "Catch.h"
#include "LightHandle.h"
#include "ViewerSession.h"

#include <QAction>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
// What a light that is seen changes at least; pictures that are the same differ by nothing.
constexpr double Seen = 2.0;
}

TEST_CASE("The selected light is shown in the view, and dragged", "[lights]")
{
  ViewerSession session;
  REQUIRE(session.Open(session.Files.File));
  const auto light = [&](int i) { return session.Document.GetScene().Lights[i]; };
  const auto before = session.TakePicture();
  session.Find<QAction>("showLight")->setChecked(true);
  CHECK(session.ChangeSince(before) == 0.0); // pictures of the scene are without it
  LightHandle* handle = session.Window.GetLightHandle();
  const ViewFrame view = session.Window.GetView()->GetFrame();
  // To the right of what is looked at: the light then comes from the right.
  handle->Drag(Sum(view.FocalPoint, Scaled(view.Right, 10.0)));
  CHECK(
    Length(Difference(light(0).Direction, Scaled(view.Right, -1.0))) == Approx(0.0).margin(1e-9));
  CHECK(session.ChangeSince(before) > Seen);
  session.Find<QAction>("addLight1")->trigger();
  handle->Drag({ 1.0, 2.0, 3.0 });
  CHECK(Length(Difference(light(1).Position, { 1.0, 2.0, 3.0 })) == Approx(0.0).margin(1e-9));
}
