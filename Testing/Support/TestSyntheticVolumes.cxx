#include "Catch.h"
#include "SyntheticVolumes.h"

#include <vtkMath.h>

using namespace penumbra;

namespace
{
const VolumeGrid grid = { { 21, 11, 41 }, { 1.0, 2.0, 0.5 }, { 5.0, -3.0, 100.0 }, VTK_DOUBLE };

double At(vtkImageData* volume, int i, int j, int k)
{
  return volume->GetScalarComponentAsDouble(i, j, k, 0);
}
}

TEST_CASE("A synthetic volume has the geometry and the type of its grid")
{
  const auto volume = MakeRamp(grid, 0);
  CHECK(volume->GetDimensions()[2] == 41);
  CHECK(volume->GetSpacing()[1] == 2.0);
  CHECK(volume->GetOrigin()[2] == 100.0);
  CHECK(volume->GetScalarType() == VTK_DOUBLE);
  CHECK(volume->GetNumberOfScalarComponents() == 1);
  CHECK(grid.Center() == Point{ 15.0, 7.0, 110.0 });
  CHECK(grid.LastSample() == Point{ 25.0, 17.0, 120.0 });
  CHECK(grid.InnerRadius() == 10.0);
}

TEST_CASE("A field is sampled at the samples' positions")
{
  const auto volume =
    SampleField(grid, [](const Point& p) { return p[0] + 100 * p[1] + 10000 * p[2]; });
  CHECK(At(volume, 3, 4, 5) == Approx(8.0 + 100 * 5.0 + 10000 * 102.5));
}

TEST_CASE("Integer types take the nearest value they can hold")
{
  VolumeGrid bytes;
  bytes.dimensions = { 4, 1, 1 };
  const double values[] = { -7.0, 1.5, 99.4, 300.0 };
  const auto field = [&](const Point& p) { return values[static_cast<int>(p[0])]; };
  const auto volume = SampleField(bytes, field);
  CHECK(At(volume, 0, 0, 0) == 0);
  CHECK(At(volume, 1, 0, 0) == 2);
  CHECK(At(volume, 2, 0, 0) == 99);
  CHECK(At(volume, 3, 0, 0) == 255);
  bytes.scalarType = VTK_SHORT;
  CHECK(At(SampleField(bytes, field), 0, 0, 0) == -7);
}

TEST_CASE("A ball is half at its radius and linear across its edge")
{
  const auto ball = MakeBall(grid, 6.0, 4.0, { 10.0, 2.0 });
  CHECK(At(ball, 10, 5, 20) == 10.0);
  CHECK(At(ball, 0, 0, 0) == 2.0);
  CHECK(At(ball, 16, 5, 20) == Approx(6.0));
  CHECK(At(ball, 10, 8, 20) == Approx(6.0));
  CHECK(At(ball, 10, 5, 20 - 12) == Approx(6.0));
  CHECK(At(ball, 15, 5, 20) == Approx(8.0));
  CHECK(At(ball, 17, 5, 20) == Approx(4.0));
}

TEST_CASE("A ball without an edge is a step at its radius")
{
  const auto ball = MakeBall(grid, 6.0, 0.0);
  CHECK(At(ball, 16, 5, 20) == 255.0);
  CHECK(At(ball, 17, 5, 20) == 0.0);
}

TEST_CASE("A slab reaches from its first to its last position")
{
  const auto slab = MakeSlab(grid, 2, 105.0, 106.0);
  CHECK(At(slab, 0, 0, 9) == 0.0);
  CHECK(At(slab, 20, 10, 10) == 255.0);
  CHECK(At(slab, 3, 7, 12) == 255.0);
  CHECK(At(slab, 3, 7, 13) == 0.0);
}

TEST_CASE("A ramp is linear from its first sample to its last")
{
  const auto ramp = MakeRamp(grid, 1, { 50.0, 10.0 });
  CHECK(At(ramp, 0, 0, 0) == 10.0);
  CHECK(At(ramp, 20, 10, 40) == 50.0);
  CHECK(At(ramp, 7, 5, 9) == Approx(30.0));
}

TEST_CASE("Shells repeat with their period")
{
  const auto shells = MakeShells(grid, 4.0);
  CHECK(At(shells, 10, 5, 20) == Approx(255.0));
  CHECK(At(shells, 12, 5, 20) == Approx(0.0).margin(1e-9));
  CHECK(At(shells, 14, 5, 20) == Approx(255.0));
  CHECK(At(shells, 10, 7, 20) == Approx(255.0));
  CHECK(At(shells, 11, 5, 20) == Approx(127.5));
}

TEST_CASE("The signal of Marschner and Lobb has its published values")
{
  const auto signal = MakeMarschnerLobb(grid, { 1.0, 0.0 });
  // On the axis rho is cos(12 pi) = 1: (1 - sin(pi z / 2) + 0.5) / 2.5.
  CHECK(At(signal, 10, 5, 20) == Approx(0.6));
  CHECK(At(signal, 10, 5, 40) == Approx(0.2));
  CHECK(At(signal, 10, 5, 0) == Approx(1.0));
  // At x = 1 in the middle plane the inner cosine is 0, so that rho is 1 again.
  CHECK(At(signal, 20, 5, 20) == Approx(0.6));
  // At r = 1/2 rho is cos(12 pi cos(pi / 4)), whatever z is.
  const double rho = std::cos(12 * vtkMath::Pi() * std::cos(vtkMath::Pi() / 4));
  CHECK(At(signal, 15, 5, 20) == Approx((1 + 0.25 * (1 + rho)) / 2.5));
  CHECK(At(signal, 15, 5, 40) == Approx(0.25 * (1 + rho) / 2.5));
  double range[2];
  signal->GetScalarRange(range);
  CHECK(range[0] >= 0.0);
  CHECK(range[1] <= 1.0);
}
