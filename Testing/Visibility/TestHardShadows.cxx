#include "Catch.h"
#include "ShadowedVolume.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
vtkSmartPointer<vtkVolumeLight> AddHard(ShadowedVolume& scene, const Point& towardsLight)
{
  const auto light = scene.AddDirectional(towardsLight);
  light->SetShadowToHard();
  return light;
}

/// Opaque where the scalar is above half of its range, and nothing below.
void SetOpaqueAboveHalf(ShadowedVolume& scene)
{
  scene.Opacity->AllowDuplicateScalarsOn();
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(127.5, 0.0);
  scene.Opacity->AddPoint(127.5, 1.0);
  scene.Opacity->AddPoint(255.0, 1.0);
}
}

// The bar's borders, halfway between voxels, are at x = 14.5 and, below, at z = 19.5; where they
// meet the edge is round. Rays leave the volume at z = 32 or, leftwards, at x = 0.
TEST_CASE("The hard shadow of an opaque bar has a sharp edge where the bar's edge projects to")
{
  VolumeGrid grid;
  grid.dimensions = { 33, 3, 33 };
  const auto volume = SampleField(
    grid, [](const Point& point) { return point[0] <= 14.0 && point[2] >= 20.0 ? 255.0 : 0.0; });
  ShadowedVolume scene(volume);
  SetOpaqueAboveHalf(scene);
  scene.Filter->SetSampleDistance(0.05);
  const double slope = GENERATE(0.0, 0.5, -0.75);
  AddHard(scene, { slope, 0.0, 1.0 });
  const std::vector<float> visibility = scene.Compute();
  const std::vector<Point> points = scene.GetPoints();
  int shadowed = 0;
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    const double below = points[point][0] + slope * (19.5 - points[point][2]);
    const double leftmost =
      slope < 0.0 ? points[point][0] + slope * (32.0 - points[point][2]) : below;
    const double margin = std::min(std::abs(below), std::abs(leftmost - 14.5));
    if (points[point][2] < 19.0 && margin >= 0.5)
    {
      const bool hidden = below > 0.0 && leftmost < 14.5;
      CHECK(visibility[point] == (hidden ? 0.0f : 1.0f));
      shadowed += hidden;
    }
  }
  CHECK(shadowed > 500);
}

TEST_CASE("A hard shadow begins where the accumulated opacity exceeds the threshold")
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 65 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.05);
  const double threshold = GENERATE(0.1, 0.5, 0.9);
  AddHard(scene, { 0.0, 0.0, 1.0 })->SetOpacityThreshold(threshold);
  const double reach = -std::log1p(-threshold) / 0.05;
  REQUIRE(std::abs(reach - std::round(reach)) > 0.05);
  CHECK(GetLargestError(
          scene, [&](const Point& point) { return 64.0 - point[2] > reach ? 0.0 : 1.0; }) == 0.0);
}

TEST_CASE("Any matter exceeds a threshold of 0")
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 9 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(1e-7);
  AddHard(scene, { 0.0, 0.0, 1.0 })->SetOpacityThreshold(0.0);
  CHECK(
    GetLargestError(scene, [](const Point& point) { return point[2] < 8.0 ? 0.0 : 1.0; }) == 0.0);
}

TEST_CASE("Nothing does not exceed a threshold of 0")
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 9 };
  ShadowedVolume scene(MakeUniform(grid));
  AddHard(scene, { 0.0, 0.0, 1.0 })->SetOpacityThreshold(0.0);
  CHECK(GetLargestError(scene, [](const Point&) { return 1.0; }) == 0.0);
}

TEST_CASE("A threshold of 1 counts as the largest opacity that matter can have")
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 9 };
  ShadowedVolume scene(MakeUniform(grid));
  AddHard(scene, { 0.0, 0.0, 1.0 })->SetOpacityThreshold(1.0);
  const double reach = 24.0 * std::log(2.0) / 3.0;
  scene.SetExtinction(3.0);
  CHECK(GetLargestError(
          scene, [&](const Point& point) { return 8.0 - point[2] > reach ? 0.0 : 1.0; }) == 0.0);
}
