#include "Catch.h"
#include "LightEdits.h"

using namespace penumbra;

namespace
{
// Looks along -z from z = 10 at the origin.
const ViewFrame View = { { 0, 0, 10 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
// Looks along -x.
const ViewFrame Side = { { 10, 0, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 } };

LightDescription MakeOne(LightType type, LightFrame frame)
{
  LightDescription light;
  light.Type = type;
  light.Frame = frame;
  light.Position = { 0, 3, -4 };
  return light;
}

void CheckEqual(const Vector3& a, const Vector3& b)
{
  CHECK(Length(Difference(a, b)) == Approx(0.0).margin(1e-12));
}
}

TEST_CASE("A light that is turned comes from where it was turned to")
{
  const auto type = GENERATE(LightType::Directional, LightType::Point, LightType::Spot);
  const auto frame = GENERATE(LightFrame::Scene, LightFrame::Camera);
  for (const ViewFrame& view : { View, Side })
  {
    LightDescription light = MakeOne(type, frame);
    const Vector3 toLight = UnitVector({ 0.3, -0.5, 0.8 });
    TurnLight(light, view, toLight);
    CheckEqual(DirectionToLight(light, view), toLight);
  }
}

TEST_CASE("A light keeps its place when its frame changes, and follows the camera from then on")
{
  const auto type = GENERATE(LightType::Directional, LightType::Point, LightType::Spot);
  LightDescription light = MakeOne(type, LightFrame::Scene);
  light.Direction = UnitVector({ 0.2, -0.4, -0.9 });
  const Vector3 before = DirectionToLight(light, Side);
  ChangeFrame(light, LightFrame::Camera, Side);
  CheckEqual(DirectionToLight(light, Side), before);
  if (type == LightType::Directional)
  {
    CheckEqual(DirectionToLight(light, View), before);
  }
  ChangeFrame(light, LightFrame::Scene, Side);
  CheckEqual(DirectionToLight(light, Side), before);
}

TEST_CASE("A light that is aimed shines at the target")
{
  LightDescription spot = MakeOne(LightType::Spot, LightFrame::Scene);
  AimLight(spot, View, { 1, 3, -4 });
  CheckEqual(spot.Direction, { 1, 0, 0 });
}

TEST_CASE("New and copied lights have names of their own")
{
  SceneDescription scene;
  scene.Lights = { MakeNewLight({}, LightType::Point, View, 1.0) };
  scene.Lights.push_back(MakeNewLight(scene, LightType::Point, View, 1.0));
  scene.Lights.push_back(CopyOfLight(scene, 0));
  CHECK(scene.Lights[0].Name != scene.Lights[1].Name);
  CHECK(scene.Lights[0].Name != scene.Lights[2].Name);
  CHECK(scene.Lights[1].Name != scene.Lights[2].Name);
}

TEST_CASE("Every rig lights what is seen, and all of its lights are valid")
{
  for (const LightRig& rig : GetLightRigs(1.0))
  {
    CAPTURE(rig.Name.toStdString());
    REQUIRE_FALSE(rig.Lights.empty());
    for (const LightDescription& light : rig.Lights)
    {
      CHECK(light.Frame == LightFrame::Camera);
      CHECK(Length(light.Direction) > 0.0);
      CHECK(light.ShadowBias == 1.0);
    }
  }
}
