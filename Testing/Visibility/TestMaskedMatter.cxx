#include "Catch.h"
#include "PartlyHidden.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
double GetHidden(double z, double low, double high)
{
  return high - std::clamp(z, low, high);
}
}

// Voxels 4 and 5 and 10 along z are hidden: from 4.75 to 5.75 and from 7.75 to 8.25.
TEST_CASE("Masked matter casts no shadow, exactly from the borders of voxels on")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  const auto mask = SampleField(grid,
    [](const Point& point)
    {
      const int z = static_cast<int>(std::lround((point[2] - 3.0) / 0.5));
      return z == 4 || z == 5 || z == 10 ? 0.0 : 3.0;
    });
  scene.Filter->SetMaskData(mask);
  scene.Filter->SetSampleDistance(GENERATE(0.2, 0.37, 100.0));
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            return Dim(
              11.0 - point[2] - GetHidden(point[2], 4.75, 5.75) - GetHidden(point[2], 7.75, 8.25));
          }) < Rounding);
}

TEST_CASE("A mask's borders are exact for oblique rays, too")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  const Point direction = { 0.6, 0.0, 0.8 };
  scene.SetExtinction(Extinction);
  scene.AddDirectional(direction);
  // Hidden where x is above 6.5.
  scene.Filter->SetMaskData(
    SampleField(grid, [](const Point& point) { return point[0] > 6.5 ? 0.0 : 1.0; }));
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const double border = (6.5 - point[0]) / direction[0];
            return Dim(std::min(GetExit(grid, point, direction), border));
          }) < Rounding);
}

TEST_CASE("A mask of a single slice hides all of its thickness")
{
  VolumeGrid grid;
  grid.dimensions = { 9, 3, 1 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  scene.Filter->SetMaskData(
    SampleField(grid, [](const Point& point) { return point[0] > 3.5 ? 0.0 : 1.0; }));
  CHECK(GetLargestError(scene, [](const Point& point) { return point[0] > 3.5 ? 1.0 : Dim(0.5); }) <
    Rounding);
}
