#include "Catch.h"
#include "ShadowedVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace penumbra;

namespace
{
VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 9, 13, 7 };
  grid.spacing = { 1.0, 0.5, 2.0 };
  grid.origin = { 3.0, 4.0, 5.0 };
  return grid;
}

void Prepare(ShadowedVolume& scene)
{
  scene.Opacity->AddPoint(255.0, 0.5);
  scene.AddDirectional({ 1.0, 0.4, 0.2 });
}

std::array<int, 3> GetDimensions(ShadowedVolume& scene)
{
  scene.Filter->Update();
  std::array<int, 3> dimensions;
  scene.Filter->GetOutput()->GetDimensions(dimensions.data());
  return dimensions;
}
}

TEST_CASE("At resolution 1 the output has the volume's own geometry")
{
  const double direction[9] = { 0, -1, 0, 1, 0, 0, 0, 0, 1 };
  const auto volume = MakeShells(MakeGrid(), 5.0);
  volume->SetDirectionMatrix(direction);
  volume->SetExtent(3, 11, -4, 8, 20, 26);
  ShadowedVolume scene(volume);
  Prepare(scene);
  scene.Filter->Update();
  vtkImageData* output = scene.Filter->GetOutput();
  int extent[6];
  output->GetExtent(extent);
  CHECK(std::equal(extent, extent + 6, volume->GetExtent()));
  for (vtkIdType point = 0; point < volume->GetNumberOfPoints(); ++point)
  {
    double expected[3];
    double found[3];
    volume->GetPoint(point, expected);
    output->GetPoint(point, found);
    REQUIRE(std::equal(found, found + 3, expected));
  }
}

TEST_CASE("Coarser and finer outputs agree with the volume's own where they share points")
{
  const auto volume = MakeShells(MakeGrid(), 5.0);
  const double direction[9] = { 0, -1, 0, 1, 0, 0, 0, 0, 1 };
  volume->SetDirectionMatrix(direction);
  volume->SetExtent(3, 11, -4, 8, 20, 26);
  ShadowedVolume scene(volume);
  Prepare(scene);
  const std::vector<float> full = scene.Compute();
  const std::vector<Point> fullPoints = scene.GetPoints();

  const double resolution = GENERATE(0.5, 2.0);
  scene.Filter->SetResolution(resolution);
  CHECK(GetDimensions(scene) ==
    (resolution < 1.0 ? std::array<int, 3>{ 5, 7, 4 } : std::array<int, 3>{ 17, 25, 13 }));
  const std::vector<float> other = scene.Compute();
  const std::vector<Point> otherPoints = scene.GetPoints();
  int shared = 0;
  for (std::size_t i = 0; i < full.size(); ++i)
  {
    for (std::size_t j = 0; j < other.size(); ++j)
    {
      if (Length(fullPoints[i] - otherPoints[j]) < 1e-9)
      {
        CHECK(full[i] == other[j]);
        ++shared;
      }
    }
  }
  CHECK(shared == (resolution < 1.0 ? 5 * 7 * 4 : 9 * 13 * 7));
}

TEST_CASE("Any numbers of points fill the box of the volume")
{
  ShadowedVolume scene(MakeShells(MakeGrid(), 5.0));
  Prepare(scene);
  scene.Filter->SetOutputDimensions(2, 0, 4);
  CHECK(GetDimensions(scene) == std::array<int, 3>{ 2, 13, 4 });
  CHECK(Length(scene.GetPoints().front() - Point{ 3.0, 4.0, 5.0 }) < 1e-12);
  CHECK(Length(scene.GetPoints().back() - Point{ 11.0, 10.0, 17.0 }) < 1e-12);
  scene.Filter->SetOutputDimensions(1, 1, 1);
  CHECK(Length(scene.GetPoints().front() - Point{ 7.0, 7.0, 11.0 }) < 1e-12);
}

TEST_CASE("A single slice is one spacing thick, half to each side")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 1 };
  grid.spacing = { 1.0, 1.0, 3.0 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.2);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  CHECK(GetLargestError(scene, [](const Point&) { return std::exp(-0.2 * 1.5); }) < 1e-6);

  scene.Filter->SetOutputDimensions(0, 0, 4);
  CHECK(Length(scene.GetPoints().back() - Point{ 4.0, 4.0, 1.5 }) < 1e-12);
  CHECK(GetLargestError(
          scene, [](const Point& point) { return std::exp(-0.2 * (1.5 - point[2])); }) < 1e-6);
}

TEST_CASE("A single voxel is a box of one spacing")
{
  VolumeGrid grid;
  grid.dimensions = { 1, 1, 1 };
  grid.spacing = { 2.0, 2.0, 2.0 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.2);
  scene.AddPoint({ 7.0, 0.0, 0.0 });
  CHECK(GetLargestError(scene, [](const Point&) { return std::exp(-0.2); }) < 1e-6);
}
