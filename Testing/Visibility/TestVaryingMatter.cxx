#include "Catch.h"
#include "ShadowedVolume.h"

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double Height = 16.0;

VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 17 };
  grid.scalarType = VTK_DOUBLE;
  return grid;
}

/// Integral of -ln(1 - u) from 0.
double IntegrateDepth(double u)
{
  return (1.0 - u) * std::log1p(-u) + u;
}

/// Opacity 0 at the scalar 0, and steepness at 1.
void SetRamp(ShadowedVolume& scene, double steepness)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.0);
  scene.Opacity->AddPoint(1.0, steepness);
}

/// Of a light above a volume whose scalar rises from 0 to 1 along z.
double GetRampError(double steepness, double sampleDistance)
{
  ShadowedVolume scene(MakeRamp(MakeGrid(), 2, { 1.0, 0.0 }));
  SetRamp(scene, steepness);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  scene.Filter->SetSampleDistance(sampleDistance);
  return GetLargestError(scene,
    [&](const Point& point)
    {
      const double depth =
        IntegrateDepth(steepness) - IntegrateDepth(steepness * point[2] / Height);
      return std::exp(-depth * Height / steepness);
    });
}
}

TEST_CASE("Through a linear ramp of opacity visibility is that of the integral")
{
  CHECK(GetRampError(0.3, 1.0 / 16.0) < 1e-5);
  CHECK(GetRampError(0.9, 1.0 / 16.0) < 1e-4);
}

// Steps of which whole numbers make up the way, then some that leave a rest.
TEST_CASE("Visibility converges with second order in the step")
{
  const double rest = GENERATE(1.0, 0.9);
  double before = GetRampError(0.5, 2.0 * rest);
  for (const double step : { 1.0, 0.5, 0.25 })
  {
    const double error = GetRampError(0.5, step * rest);
    const double order = std::log2(before / error);
    CHECK(order > 1.8);
    before = error;
  }
}

TEST_CASE("Through an exponential atmosphere visibility is that of the integral")
{
  constexpr double ground = 0.4;
  constexpr double scaleHeight = 5.0;
  const auto volume = SampleField(MakeGrid(),
    [](const Point& point) { return -std::expm1(-ground * std::exp(-point[2] / scaleHeight)); });
  ShadowedVolume scene(volume);
  SetRamp(scene, 1.0);
  const Point towardsLight = GENERATE(Point{ 0.0, 0.0, 1.0 }, Point{ 0.0, 0.0, -1.0 });
  scene.AddDirectional(towardsLight);
  // Interpolation between voxels is off by the square of a voxel over eight times that of the
  // scale height.
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const double end = towardsLight[2] > 0.0 ? Height : 0.0;
            const double depth = ground * scaleHeight *
              std::abs(std::exp(-point[2] / scaleHeight) - std::exp(-end / scaleHeight));
            return std::exp(-depth);
          }) < 2e-3);
}

// A product of three linear functions, which interpolation between voxels meets exactly.
TEST_CASE("Matter that varies along all axes is interpolated between all eight voxels")
{
  VolumeGrid grid;
  grid.dimensions = { 6, 5, 7 };
  grid.spacing = { 1.0, 1.5, 0.5 };
  grid.scalarType = VTK_DOUBLE;
  const auto field = [](const Point& p)
  { return (1.0 + p[0]) * (7.0 - p[1]) * (1.0 + 2.0 * p[2]) / 400.0; };
  ShadowedVolume scene(SampleField(grid, field));
  SetRamp(scene, 1.0);
  const Point towardsLight = GENERATE(Point{ 0.2, 0.6, 0.1 }, Point{ -0.5, 0.3, 0.2 });
  scene.AddDirectional(towardsLight);
  scene.Filter->SetSampleDistance(0.02);
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const double length = GetExit(grid, point, towardsLight);
            constexpr int steps = 400;
            double depth = 0.0;
            for (int step = 0; step < steps; ++step)
            {
              const double part = (step + 0.5) / steps * length / Length(towardsLight);
              depth -= std::log1p(-field(point + part * towardsLight)) * length / steps;
            }
            return std::exp(-depth);
          }) < 1e-5);
}

TEST_CASE("A peak of opacity that is a tenth of a voxel wide counts in full")
{
  ShadowedVolume scene(MakeRamp(MakeGrid(), 2, { 16.0, 0.0 }));
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(7.0, 0.0);
  scene.Opacity->AddPoint(7.1, 0.8);
  scene.Opacity->AddPoint(7.2, 0.0);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  scene.Filter->SetSampleDistance(0.001);
  const double depth = 0.2 * IntegrateDepth(0.8) / 0.8;
  CHECK(GetLargestError(scene,
          [&](const Point& point) { return point[2] < 7.5 ? std::exp(-depth) : 1.0; }) < 1e-5);
}

TEST_CASE("Steps of 0, below, or NaN are half the smallest spacing")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 9 };
  grid.spacing = { 1.0, 2.0, 0.5 };
  ShadowedVolume scene(MakeShells(grid, 3.0));
  scene.Opacity->AddPoint(255.0, 0.5);
  scene.AddDirectional({ 0.3, 0.3, 1.0 });
  scene.Filter->SetSampleDistance(0.25);
  const std::vector<float> expected = scene.Compute();
  scene.Filter->SetSampleDistance(GENERATE(0.0, -1.0, std::numeric_limits<double>::quiet_NaN()));
  CHECK(GetLargestDifference(scene.Compute(), expected) == 0.0);
  scene.Filter->SetSampleDistance(std::numeric_limits<double>::infinity());
  CHECK(GetLargestDifference(scene.Compute(), expected) > 0.0);
}
