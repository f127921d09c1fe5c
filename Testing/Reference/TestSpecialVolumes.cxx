#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
vtkSmartPointer<vtkImageData> MakeFloats(
  const std::array<int, 3>& dimensions, const ScalarField& field)
{
  VolumeGrid grid;
  grid.dimensions = dimensions;
  grid.spacing = { 1.0, 1.5, 2.0 };
  grid.scalarType = VTK_FLOAT;
  return SampleField(grid, field);
}

double GetAlpha(double opacity, double length)
{
  return 1.0 - std::pow(1.0 - opacity, length);
}
}

TEST_CASE("An axis of one voxel is one spacing thick, half to each side")
{
  const auto material = MakeMaterial({ { 0.0, 0.0 }, { 1.0, 0.5 } }, 1.0);
  const auto slice = MakeFloats({ 4, 4, 1 }, [](const Point&) { return 1.0; });
  auto scene = MakeScene(slice, material);
  scene.Camera = MakeParallelCamera({ 1.5, 2.0, 0.0 }, { 0.0, 0.0, -1.0 });
  CHECK(ComputeMiddle(scene).Color[3] == Approx(GetAlpha(0.5, 2.0)).margin(1e-6));
  scene.Camera = MakeParallelCamera({ 1.5, 2.0, 0.9 }, { 1.0, 0.0, 0.0 });
  CHECK(ComputeMiddle(scene).Color[3] == Approx(GetAlpha(0.5, 3.0)).margin(1e-6));
  scene.Camera = MakeParallelCamera({ 1.5, 2.0, 1.1 }, { 1.0, 0.0, 0.0 });
  CHECK(ComputeMiddle(scene).Color[3] == 0.0);
  const auto voxel = MakeFloats({ 1, 1, 1 }, [](const Point&) { return 1.0; });
  CHECK(ComputeMiddle(MakeScene(voxel, material, { 0.0, 1.0, 0.0 })).Color[3] ==
    Approx(GetAlpha(0.5, 1.5)).margin(1e-6));
}

TEST_CASE("A slice's normal lies within it")
{
  const auto material = MakeMaterial({ { 0.0, 0.5 } }, 1.0);
  material->ShadeOn();
  auto scene =
    MakeScene(MakeFloats({ 5, 4, 1 }, [](const Point& p) { return p[0] + 2.0 * p[1]; }), material);
  scene.Camera = MakeParallelCamera({ 2.0, 2.0, 0.0 }, { 0.0, 0.0, -1.0 });
  scene.Lights = { MakeDirectionalLight({ 1.0, 0.0, 0.0 }) };
  CHECK(ComputeMiddle(scene).Color[0] == Approx(GetAlpha(0.5, 2.0) / std::sqrt(5.0)).margin(1e-5));
}

TEST_CASE("NaN and infinities count as the smallest and the largest finite value")
{
  const double odd = GENERATE(std::numeric_limits<double>::quiet_NaN(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  const double replaced = odd > 0.0 ? 9.0 : -2.0;
  const auto field = [](double value)
  {
    return [value](const Point& p) {
      return p[2] == 4.0 ? value : p[0] == 0.0 ? 9.0 : p[0] == 1.0 ? -2.0 : 3.0;
    };
  };
  const auto material = MakeMaterial({ { -2.0, 0.0 }, { 9.0, 0.8 } }, 1.0);
  auto scene = MakeScene(MakeFloats({ 4, 4, 5 }, field(odd)), material, { 0.1, 0.2, -1.0 });
  const auto alpha = ComputeMiddle(scene).Color[3];
  CHECK(ReferenceIntegrator(scene).GetWarnings().size() == 1);
  scene.Volume = MakeFloats({ 4, 4, 5 }, field(replaced));
  CHECK(alpha == Approx(ComputeMiddle(scene).Color[3]).margin(1e-9));
  CHECK(ReferenceIntegrator(scene).GetWarnings().empty());
}

TEST_CASE("Without interpolation each voxel reaches halfway to the next")
{
  const auto volume = MakeFloats({ 3, 3, 5 }, [](const Point& p) { return p[2]; });
  const auto material = MakeMaterial({ { 5.0, 0.3 }, { 5.0, 0.0 } }, 1.0);
  auto scene = MakeScene(volume, material);
  CHECK(ComputeMiddle(scene).Color[3] == Approx(GetAlpha(0.3, 5.0)).margin(1e-6));
  material->SetInterpolationTypeToNearest();
  // Voxels at 0, 2 and 4, of which the first begins in its middle.
  scene.Camera = MakeParallelCamera({ 1.1, 1.6, 0.0 }, { 0.0, 0.0, -1.0 });
  CHECK(ComputeMiddle(scene).Color[3] == Approx(GetAlpha(0.3, 5.0)).margin(1e-6));
  scene.Cropping = { { -1.0, 9.0, -1.0, 9.0, 4.5, 9.0 } };
  CHECK(ComputeMiddle(scene).Color[3] == Approx(GetAlpha(0.3, 0.5)).margin(1e-6));
}

TEST_CASE("An extent need not begin at 0")
{
  const auto volume = MakeFloats({ 4, 4, 5 }, [](const Point& p) { return p[2]; });
  const auto material = MakeMaterial({ { 0.0, 0.0 }, { 8.0, 0.8 } }, 1.0);
  auto scene = MakeScene(volume, material);
  scene.Cropping = { { -10.0, 10.0, -10.0, 10.0, 1.0, 6.5 } };
  const double alpha = ComputeMiddle(scene).Color[3];
  volume->SetExtent(7, 10, -3, 0, 100, 104);
  volume->SetOrigin(-7.0, 4.5, -200.0);
  CHECK(ComputeMiddle(scene).Color[3] == Approx(alpha).margin(1e-9));
}
