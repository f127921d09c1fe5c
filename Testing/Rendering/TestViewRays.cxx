#include "Catch.h"
#include "ViewedVolume.h"

#include <cmath>

using namespace penumbra;

namespace
{
// As the shader computes it: a matrix and a position on the image in single precision.
Vector3 GetColumnSum(const Matrix3& matrix, const Vector3& image)
{
  const auto x = static_cast<float>(image[0]);
  const auto y = static_cast<float>(image[1]);
  Vector3 sum;
  for (int row = 0; row < 3; ++row)
  {
    sum[row] = static_cast<float>(matrix[3 * row]) * x +
      static_cast<float>(matrix[3 * row + 1]) * y + static_cast<float>(matrix[3 * row + 2]);
  }
  return sum;
}

template <typename Check>
void ForEachView(const Check& check)
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    for (const View& view : MakeViews())
    {
      INFO(volume.name << ", " << view.name);
      check(ViewedVolume(volume, view));
    }
  }
}
}

TEST_CASE("The ray of a pixel passes through what the pixel shows")
{
  std::mt19937 generator(40);
  ForEachView(
    [&](const ViewedVolume& viewed)
    {
      for (int sample = 0; sample < 10; ++sample)
      {
        const Vector3 shown = RandomPointInBox(viewed.geometry, generator);
        if (viewed.Depth(shown) < 0.05 * viewed.radius)
        {
          continue;
        }
        const Vector3 image = viewed.Project(shown);
        const Vector3 base = GetColumnSum(viewed.rays.Base, image);
        const Vector3 direction = GetColumnSum(viewed.rays.Direction, image);
        const Vector3 fromBase = { shown[0] - base[0], shown[1] - base[1], shown[2] - base[2] };
        const double along =
          GetDotProduct(fromBase, direction) / GetDotProduct(direction, direction);
        const Vector3 nearest = PointOnRay(base, direction, along);
        // A few units in the last place of texture coordinates: 1e-5 voxels here, 1e-3 among 1000.
        CHECK(GetDistance(nearest, shown) <= 1e-6);
        // And the pixel it projects back to, of 1000 across the image: within a hundredth.
        const Vector3 back = viewed.Project(nearest);
        CHECK(500.0 * std::hypot(back[0] - image[0], back[1] - image[1]) <= 0.01);
      }
    });
}

TEST_CASE("The eye is at the eye's parameter, and rays lead away from it")
{
  ForEachView(
    [&](const ViewedVolume& viewed)
    {
      for (const Vector3& image : { Vector3{ 0.0, 0.0 }, Vector3{ 0.5, -0.75 } })
      {
        Vector3 base;
        Vector3 direction;
        for (int row = 0; row < 3; ++row)
        {
          const double* ofBase = viewed.rays.Base.data() + 3 * row;
          const double* ofDirection = viewed.rays.Direction.data() + 3 * row;
          base[row] = ofBase[0] * image[0] + ofBase[1] * image[1] + ofBase[2];
          direction[row] = ofDirection[0] * image[0] + ofDirection[1] * image[1] + ofDirection[2];
        }
        const Vector3 atEye = PointOnRay(base, direction, viewed.rays.EyeParameter);
        const Vector3 eye = viewed.Eye();
        // Rounding at coordinates up to 1e5 and at the distance of the eye.
        const double distance = std::abs(viewed.Depth({ 0.5, 0.5, 0.5 }));
        const double tolerance = 1e-9 * (distance + viewed.radius + GetLength(eye));
        CHECK(viewed.Depth(atEye) == Approx(0.0).margin(tolerance));
        if (!viewed.camera->GetParallelProjection())
        {
          CHECK(GetDistance(viewed.volume.ToWorld(atEye), eye) <= tolerance);
        }
        CHECK(viewed.Depth(PointOnRay(base, direction, 1.0)) > viewed.Depth(base));
      }
    });
}

TEST_CASE("Depths along a ray are those of the projection")
{
  std::mt19937 generator(41);
  ForEachView(
    [&](const ViewedVolume& viewed)
    {
      const Vector3 point = RandomPointInBox(viewed.geometry, generator);
      const auto multiply = [&](const std::array<double, 4>& row) {
        return GetDotProduct({ row[0], row[1], row[2] }, point) + row[3];
      };
      const double depth = multiply(viewed.rays.ClipDepth) / multiply(viewed.rays.ClipW);
      // Far away, depths from -1 to 1 are differences of numbers near 1e6.
      CHECK(depth == Approx(viewed.Project(point)[2]).margin(1e-6).epsilon(1e-6));
    });
}
