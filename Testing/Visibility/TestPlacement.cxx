#include "Catch.h"
#include "ShadowedVolume.h"

#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkTransform.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Rounding = 3e-6;

vtkSmartPointer<vtkMatrix4x4> MakeMatrix(const std::array<double, 9>& linear, const Point& shift)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, linear[3 * row + column]);
    }
    matrix->SetElement(row, 3, shift[row]);
  }
  return matrix;
}

Point Map(vtkMatrix4x4* matrix, const Point& point, double w)
{
  const double from[4] = { point[0], point[1], point[2], w };
  double to[4];
  matrix->MultiplyPoint(from, to);
  return { to[0], to[1], to[2] };
}

const std::array<double, 9> Identity = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
const std::array<double, 9> Mirrored = { -1, 0, 0, 0, 1, 0, 0, 0, 1 };
const std::array<double, 9> Sheared = { 1, 0, 0.3, 0, 1, -0.4, 0, 0, 0.9 };
const std::array<double, 9> Turned = { 0, -1, 0, 0.6, 0, -0.8, 0.8, 0, 0.6 };
const std::array<double, 9> Stretched = { 2, 0.5, 0, 0, 0.25, 0, 0, 0, -3 };
}

// The way of light through the box is found in voxels, where the box is a box, and measured in the
// volume's own coordinates.
TEST_CASE("Any direction matrix and any actor's matrix place the volume among its lights")
{
  VolumeGrid voxels;
  voxels.dimensions = { 8, 7, 6 };
  const auto direction = GENERATE(Identity, Mirrored, Sheared, Turned);
  const auto actor = GENERATE(Identity, Mirrored, Sheared, Turned, Stretched);
  const bool positional = GENERATE(false, true);

  const Point spacing = { 1.1, 0.7, 1.6 };
  const auto volume = MakeUniform(voxels);
  volume->SetSpacing(spacing.data());
  volume->SetOrigin(10.0, -20.0, 30.0);
  volume->SetDirectionMatrix(direction.data());
  const auto actorMatrix = MakeMatrix(actor, { 5.0, 6.0, -7.0 });

  ShadowedVolume scene(volume);
  scene.SetExtinction(0.08);
  scene.Filter->SetMatrix(actorMatrix);
  const Point toLight = { 0.3, -1.0, 0.7 };
  const Point position = Map(actorMatrix, { 13.0, -19.0, 33.0 }, 1.0);
  positional ? scene.AddPoint(position) : scene.AddDirectional(toLight);

  vtkNew<vtkMatrix4x4> toOwn;
  toOwn->DeepCopy(volume->GetIndexToPhysicalMatrix());
  vtkNew<vtkMatrix4x4> toVoxels;
  vtkMatrix4x4::Multiply4x4(actorMatrix, toOwn, toVoxels);
  toVoxels->Invert();
  vtkNew<vtkMatrix4x4> ownToVoxels;
  vtkMatrix4x4::Invert(toOwn, ownToVoxels);
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const Point world = Map(actorMatrix, point, 1.0);
            const Point way = Map(toVoxels, positional ? position - world : toLight, 0.0);
            const double exit = GetExit(voxels, Map(ownToVoxels, point, 1.0), way) / Length(way);
            const double part = positional ? std::min(exit, 1.0) : exit;
            return std::exp(-0.08 * part * Length(Map(toOwn, way, 0.0)));
          }) < Rounding);
}

// The same matter in the same place: voxels in reversed order along x, and x reversed.
TEST_CASE("A mirrored volume of reversed voxels is the same volume")
{
  VolumeGrid grid;
  grid.dimensions = { 12, 11, 10 };
  const auto compute = [&](bool mirrored)
  {
    const auto volume = SampleField(grid,
      [&](const Point& point)
      {
        const double x = mirrored ? 11.0 - point[0] : point[0];
        return 20.0 * x + 3.0 * point[1] * std::sin(point[2]);
      });
    if (mirrored)
    {
      volume->SetDirectionMatrix(Mirrored.data());
      volume->SetOrigin(11.0, 0.0, 0.0);
    }
    ShadowedVolume scene(volume);
    scene.Opacity->AddPoint(255.0, 0.5);
    scene.AddDirectional({ 1.0, 0.5, -0.7 });
    return scene.Compute();
  };
  const std::vector<float> straight = compute(false);
  const std::vector<float> mirrored = compute(true);
  double largest = 0.0;
  for (std::size_t point = 0; point < straight.size(); ++point)
  {
    const std::size_t x = point % 12;
    largest = std::max<double>(largest, std::abs(straight[point] - mirrored[point - x + 11 - x]));
  }
  CHECK(largest < Rounding);
}

TEST_CASE("Units change nothing, of the world or of the volume")
{
  VolumeGrid grid;
  grid.dimensions = { 9, 8, 10 };
  const double factor = GENERATE(1e-6, 0.3, 1e6);
  const bool world = GENERATE(false, true);
  const auto compute = [&](double scale)
  {
    const auto volume = MakeShells(grid, 6.0);
    ShadowedVolume scene(volume);
    scene.Opacity->AddPoint(255.0, 0.4);
    const auto light = scene.AddPoint({ 20.0 * scale, 3.0 * scale, 15.0 * scale });
    if (world)
    {
      vtkNew<vtkTransform> transform;
      transform->Scale(scale, scale, scale);
      scene.Filter->SetMatrix(transform->GetMatrix());
      light->SetShadowBias(0.7);
    }
    else
    {
      volume->SetSpacing(scale, scale, scale);
      scene.Property->SetScalarOpacityUnitDistance(scale);
      light->SetShadowBias(0.7 * scale);
    }
    return scene.Compute();
  };
  CHECK(GetLargestDifference(compute(factor), compute(1.0)) < Rounding);
}

TEST_CASE("A light's own transform places it")
{
  VolumeGrid grid;
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.1);
  const auto light = scene.AddDirectional({ 0.0, 0.0, 1.0 });
  vtkNew<vtkTransform> transform;
  transform->RotateX(90.0);
  light->SetTransformMatrix(transform->GetMatrix());
  CHECK(GetLargestError(scene, [](const Point& point) { return std::exp(-0.1 * point[1]); }) <
    Rounding);
}
