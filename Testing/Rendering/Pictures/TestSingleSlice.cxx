#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

// A slice counts as one spacing thick: seen along it, matter of opacity a per unit distance has
// exactly the opacity a over a spacing of that distance.
TEST_CASE("Single slice: its opacity is that of one spacing", "[slice]")
{
  const int axis = GENERATE(0, 1, 2);
  VolumeGrid grid;
  grid.dimensions = { 24, 24, 24 };
  grid.dimensions[axis] = 1;
  IlluminatedScene scene(SampleField(grid, [](const Point&) { return 120.0; }), 33, 33);
  scene.Shade(false);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  double from[3] = { 0.0, 0.0, 0.0 };
  from[axis] = 1.0;
  const Point center = grid.Center();
  scene.LookFrom(from[0], from[1] + 1e-9, from[2] + 2e-9, 60.0, center.data());
  const double red = scene.Render()->GetScalarComponentAsDouble(16, 16, 0, 0) / 255.0;
  // Half a grey level of rounding.
  CHECK(red == Approx(0.25 * 0.9).margin(0.5 / 255.0 + 1e-4));
}

TEST_CASE("Single slice: lit by its gradient within the slice", "[slice]")
{
  VolumeGrid grid;
  grid.dimensions = { 24, 24, 1 };
  IlluminatedScene scene(MakeRamp(grid, 0), 64, 64);
  scene.AddDirectionalLight(1.0, 0.0, 0.0, vtkVolumeLight::Soft);
  const auto lit = scene.Render();
  scene.GetLight()->SwitchOff();
  CHECK(CompareImages(lit, scene.Render()).rmse > 3.0);
}
