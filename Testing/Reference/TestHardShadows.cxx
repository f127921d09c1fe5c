#include "Catch.h"
#include "ReferenceScenes.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

TEST_CASE("A hard shadow ends where the accumulated opacity reaches the threshold")
{
  const double threshold = GENERATE(0.0, 0.5, 0.95, 1.0);
  const double s = 0.8;
  VolumeGrid grid;
  grid.dimensions = { 2, 2, 41 };
  grid.spacing = { 1e3, 1e3, 1.0 };
  grid.origin = { -500.0, -500.0, 0.0 };
  grid.scalarType = VTK_DOUBLE;
  const auto volume = SampleField(grid, [](const Point& p) { return 40.0 - p[2]; });
  const auto light = MakeDirectionalLight({ 0.6, 0.0, -0.8 });
  light->SetShadowToHard();
  light->SetShadowBias(0.5);
  light->SetOpacityThreshold(threshold);
  const auto material = MakeMaterial({ { 0.0, 1.0 - std::exp(-s) } }, 1.0);
  material->ShadeOn();
  auto scene = MakeScene(volume, material);
  scene.Lights = { light };
  const double largest = std::min(threshold, 1.0 - std::pow(2.0, -24.0));
  const double lit = 0.8 * (0.5 - std::log(1.0 - largest) / s);
  const double expected = 0.8 * (1.0 - std::exp(-s * lit));
  const ReferencePixel pixel = ComputeMiddle(scene);
  CHECK(std::abs(pixel.Color[0] - expected) * 255.0 <= pixel.Error + 1e-6);
  CHECK(pixel.Converged);
}

TEST_CASE("A hard shadow's edge is exactly where the light passes the edge of an opaque slab")
{
  // A floor below 2 and a roof from 6 to 8, of which the mask leaves x < 0.5.
  VolumeGrid grid;
  grid.dimensions = { 21, 3, 11 };
  grid.spacing = { 1.0, 10.0, 1.0 };
  grid.origin = { -10.0, -10.0, 0.0 };
  grid.scalarType = VTK_DOUBLE;
  const auto material = MakeMaterial(
    { { 2.0, 1.0 }, { 2.0, 0.0 }, { 6.0, 0.0 }, { 6.0, 1.0 }, { 8.0, 1.0 }, { 8.0, 0.0 } }, 1e-6);
  material->ShadeOn();
  auto scene = MakeScene(SampleField(grid, [](const Point& p) { return p[2]; }), material);
  scene.Mask = SampleField(grid, [](const Point& p) { return p[2] < 5.0 || p[0] < 0.5; });
  scene.TwoSidedLighting = true;
  const auto light = MakeDirectionalLight({ 0.6, 0.0, -0.8 });
  light->SetShadowToHard();
  light->SetShadowBias(1.0);
  scene.Lights = { light };
  const double edge = 0.5 + (8.0 - 2.0) * 0.75;
  CHECK(ComputePlane(scene, edge - 1e-5, 0.0)[0] == 0.0);
  CHECK(ComputePlane(scene, edge + 1e-5, 0.0)[0] == Approx(0.8).margin(1e-5));
  // The roof itself is lit.
  CHECK(ComputePlane(scene, -1.0, 0.0)[0] == Approx(0.8).margin(1e-5));
}
