#include "Catch.h"
#include "ShadowedVolume.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Extinction = 0.07;
constexpr double Rounding = 2e-6;

VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 9, 7, 8 };
  grid.spacing = { 1.0, 1.5, 0.8 };
  grid.origin = { -3.0, 5.0, 1.0 };
  return grid;
}

double Dim(double length)
{
  return std::exp(-Extinction * std::max(length, 0.0));
}
}

TEST_CASE("A directional light is dimmed by the way to where its rays leave the volume")
{
  const VolumeGrid grid = MakeGrid();
  const Point towardsLight = GENERATE(Point{ 0.0, 0.0, 1.0 }, Point{ -1.0, 0.0, 0.0 },
    Point{ 1.0, 2.0, 3.0 }, Point{ -3.0, 0.5, -1.0 }, Point{ 0.0, -1.0, 1.0 });
  const double bias = GENERATE(0.0, 0.3, 1.7, 100.0);
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  scene.AddDirectional(towardsLight)->SetShadowBias(bias);
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          { return Dim(GetExit(grid, point, towardsLight) - bias); }) < Rounding);
}

TEST_CASE("A point or spot light is dimmed no further than to where it is")
{
  const VolumeGrid grid = MakeGrid();
  const Point position =
    GENERATE(Point{ 20.0, 30.0, 40.0 }, Point{ 1.3, 8.2, 4.1 }, Point{ 5.0, 14.0, 6.6 });
  const bool spot = GENERATE(false, true);
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  const auto light = scene.AddPoint(position);
  light->SetConeAngle(spot ? 20.0 : 90.0);
  light->SetShadowBias(0.4);
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const Point way = position - point;
            return Dim(std::min(GetExit(grid, point, way), Length(way)) - 0.4);
          }) < Rounding);
}

TEST_CASE("A light at a point of the volume is not dimmed there")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(10.0);
  const Point voxel = grid.origin + Point{ 3 * 1.0, 2 * 1.5, 4 * 0.8 };
  scene.AddPoint(voxel);
  const std::vector<float> visibility = scene.Compute();
  CHECK(visibility[3 + 9 * (2 + 7 * 4)] == 1.0f);
  CHECK(visibility[0] < 1e-6f);
}

TEST_CASE("A directional light without a direction is not dimmed")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  scene.SetExtinction(Extinction);
  scene.AddDirectional({ 0.0, 0.0, 0.0 });
  CHECK(GetLargestError(scene, [](const Point&) { return 1.0; }) == 0.0);
}

TEST_CASE("A headlight's rays run against the direction of projection")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  const auto light = scene.AddDirectional({ 1.0, 2.0, 3.0 });
  light->SetLightTypeToHeadlight();
  CHECK(GetLargestError(scene,
          [&](const Point& point) {
            return Dim(GetExit(grid, point, { 0.0, 0.0, 1.0 }));
          }) < Rounding);
  scene.Filter->SetCameraDirection(3.0, -1.0, 2.0);
  CHECK(GetLargestError(scene,
          [&](const Point& point) {
            return Dim(GetExit(grid, point, { -3.0, 1.0, -2.0 }));
          }) < Rounding);
}

TEST_CASE("By default a shadow ray begins the smallest voxel spacing away")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(Extinction);
  scene.AddDirectional({ 0.0, 1.0, 0.0 })->SetShadowBias(-1.0);
  CHECK(GetLargestError(scene,
          [&](const Point& point) {
            return Dim(GetExit(grid, point, { 0.0, 1.0, 0.0 }) - 0.8);
          }) < Rounding);
}

TEST_CASE("Opacity is per unit distance")
{
  const VolumeGrid grid = MakeGrid();
  const double unitDistance = GENERATE(1e-6, 0.5, 3.0, 1e6);
  ShadowedVolume scene(MakeUniform(grid));
  scene.Property->SetScalarOpacityUnitDistance(unitDistance);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.4);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  CHECK(GetLargestError(scene,
          [&](const Point& point) {
            return std::pow(0.6, GetExit(grid, point, { 0.0, 0.0, 1.0 }) / unitDistance);
          }) < Rounding);
}

TEST_CASE("Full opacity counts as the largest that matter can have")
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, 9 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.Property->SetScalarOpacityUnitDistance(10.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, GENERATE(1.0, 7.0));
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  const double extinction = 24.0 * std::log(2.0) / 10.0;
  CHECK(GetLargestError(scene,
          [&](const Point& point) { return std::exp(-extinction * (8.0 - point[2])); }) < Rounding);
}

TEST_CASE("A soft shadow that leaves a negligible part of the light is complete")
{
  const VolumeGrid grid = MakeGrid();
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.5);
  scene.AddDirectional({ 1.0, 0.0, 0.0 });
  scene.Filter->SetNegligibleVisibility(0.1);
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const double visibility = std::exp(-0.5 * GetExit(grid, point, { 1.0, 0.0, 0.0 }));
            return visibility < 0.1 ? 0.0 : visibility;
          }) < Rounding);
}
