#include "Catch.h"
#include "ReferenceScenes.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
vtkSmartPointer<vtkImageData> MakeUniform(const Point& spacing)
{
  VolumeGrid grid;
  grid.dimensions = { 6, 5, 9 };
  grid.spacing = spacing;
  grid.origin = { 3.0, -2.0, 10.0 };
  return SampleField(grid, [](const Point&) { return 100.0; });
}

/// Of a ray through the box's middle.
double GetChord(vtkImageData* volume, const Point& direction)
{
  const double* bounds = volume->GetBounds();
  double chord = VTK_DOUBLE_MAX;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double along = std::abs(direction[axis]);
    chord = std::min(chord, (bounds[2 * axis + 1] - bounds[2 * axis]) / along);
  }
  return chord * std::hypot(direction[0], direction[1], direction[2]);
}
}

TEST_CASE("A homogeneous box absorbs by the length of the ray in it")
{
  const double opacity = GENERATE(0.01, 0.2, 0.9);
  const double unit = GENERATE(0.5, 3.0);
  const Point direction =
    GENERATE(Point{ 0.0, 0.0, -1.0 }, Point{ 1.0, 0.0, 0.0 }, Point{ 0.3, -0.5, 0.9 });
  const auto volume = MakeUniform({ 0.7, 1.0, 0.4 });
  const auto scene = MakeScene(volume, MakeMaterial({ { 0.0, opacity } }, unit), direction);
  const ReferencePixel pixel = ComputeMiddle(scene);
  const double expected = 1.0 - std::pow(1.0 - opacity, GetChord(volume, direction) / unit);
  const double error = std::abs(pixel.Color[3] - expected) * 255.0;
  CHECK(error <= pixel.Error + 1e-9);
  CHECK(pixel.Error <= 0.05);
  // White matter has as much colour as it has opacity.
  CHECK(pixel.Color[0] == Approx(expected).margin(0.05 / 255.0));
}

TEST_CASE("Through a ball the light depends on the chord's length")
{
  VolumeGrid grid;
  grid.dimensions = { 49, 49, 49 };
  grid.scalarType = VTK_DOUBLE;
  const Point center = grid.Center();
  const auto distance = [&](const Point& p)
  { return std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]); };
  constexpr double radius = 20.0;
  const auto material = MakeMaterial({ { radius, 0.1 }, { radius, 0.0 } }, 5.0);
  auto scene = MakeScene(SampleField(grid, distance), material);
  for (const double offset : { 3.0, 10.3, 17.2, 19.0 })
  {
    const Point seen = { center[0] + offset * 0.6, center[1] - offset * 0.8, center[2] };
    scene.Camera = MakeParallelCamera(seen, { 0.0, 0.0, -1.0 });
    const double chord = 2.0 * std::sqrt(radius * radius - offset * offset);
    // The interpolated surface is up to 1/8 1/radius 2 voxels nearer than the sphere.
    const double inside = 2.0 * std::sqrt(std::pow(radius - 0.0125, 2) - offset * offset);
    const double alpha = ComputeMiddle(scene).Color[3];
    CAPTURE(offset);
    CHECK(alpha < 1.0 - std::pow(0.9, chord / 5.0) + 1e-6);
    CHECK(alpha > 1.0 - std::pow(0.9, inside / 5.0) - 1e-6);
  }
}

TEST_CASE("An eye within the matter sees only what is before it")
{
  const auto volume = MakeUniform({ 1.0, 1.0, 1.0 });
  auto scene = MakeScene(volume, MakeMaterial({ { 0.0, 0.3 } }, 1.0));
  Point center;
  volume->GetCenter(center.data());
  for (const bool parallel : { false, true })
  {
    scene.Camera->SetParallelProjection(parallel);
    scene.Camera->SetPosition(center[0], center[1], center[2] + 1.0);
    scene.Camera->SetFocalPoint(center.data());
    // From one above the middle down to four below it.
    CHECK(ComputeMiddle(scene).Color[3] == Approx(1.0 - std::pow(0.7, 5.0)).margin(1e-6));
  }
}

TEST_CASE("What is behind the volume is seen by what it lets through")
{
  const auto volume = MakeUniform({ 1.0, 1.0, 1.0 });
  auto scene = MakeScene(volume, MakeMaterial({ { 0.0, 0.05 } }, 1.0));
  scene.Background = { 0.5, 0.25, 1.0 };
  const double alpha = 1.0 - std::pow(0.95, 8.0);
  const ReferencePixel pixel = ComputeMiddle(scene);
  for (int channel = 0; channel < 3; ++channel)
  {
    const double expected = alpha + (1.0 - alpha) * scene.Background[channel];
    CHECK(pixel.Color[channel] == Approx(expected).margin(1e-6));
  }
}
