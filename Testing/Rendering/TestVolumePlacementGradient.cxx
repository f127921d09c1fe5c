#include "Catch.h"
#include "PlacedVolume.h"

using namespace penumbra;

namespace
{
Vector3 Multiply(const Matrix3& matrix, const Vector3& vector)
{
  Vector3 product{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      product[row] += matrix[3 * row + column] * vector[column];
    }
  }
  return product;
}

// What central differences of a field of this gradient give per voxel, computed from where VTK puts
// the voxels: toFrame maps texture coordinates to the frame of the gradient.
template <typename Map>
Vector3 GetDifferences(const PlacedVolume& volume, const Vector3& gradient, const Map& toFrame)
{
  const int* dimensions = volume.image->GetDimensions();
  const Vector3 middle = { 0.5, 0.5, 0.5 };
  Vector3 differences;
  for (int axis = 0; axis < 3; ++axis)
  {
    Vector3 next = middle;
    next[axis] += 1.0 / dimensions[axis];
    differences[axis] =
      GetDotProduct(gradient, toFrame(next)) - GetDotProduct(gradient, toFrame(middle));
  }
  return differences;
}

// Differences of coordinates near 1e5 over voxels of size 1, or of 10 over voxels of 1e-3.
constexpr double Rounding = 1e-9;
const Vector3 Gradient = { 0.3, -0.8, 0.5 };
}

TEST_CASE(
  "A linear field's gradient comes out of its differences in the direction it has in the world")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const Vector3 differences = GetDifferences(
      volume, Gradient, [&](const Vector3& texture) { return volume.ToWorld(texture); });
    const Vector3 found = Normalized(Multiply(volume.Geometry().GetGradientToWorld(), differences));
    CHECK(GetDistance(found, Normalized(Gradient)) <= Rounding);
  }
}

TEST_CASE("A gradient's magnitude is that of the own frame times the mean spacing")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    const Vector3 differences = GetDifferences(
      volume, Gradient, [&](const Vector3& texture) { return volume.ToOwn(texture); });
    const Vector3 found = Multiply(geometry.GetGradientToMagnitude(), differences);
    CHECK(GetLength(found) == Approx(GetLength(Gradient) * geometry.MeanSpacing).epsilon(Rounding));
  }
}

TEST_CASE("Gradients stay within what single precision can hold at every scale")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    double largest = 0.0;
    for (const double element : volume.Geometry().GetGradientToWorld())
    {
      largest = std::max(largest, std::abs(element));
    }
    CHECK(largest == Approx(1.0));
  }
}
