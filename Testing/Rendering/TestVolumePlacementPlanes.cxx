#include "Catch.h"
#include "PlacedVolume.h"

#include <vtkNew.h>
#include <vtkPlane.h>

#include <cmath>

using namespace penumbra;

namespace
{
double GetHeight(const std::array<double, 4>& plane, const Vector3& point)
{
  return GetDotProduct({ plane[0], plane[1], plane[2] }, point) + plane[3];
}

double ToTexture(vtkImageData* image, int axis, double index)
{
  const int* extent = image->GetExtent();
  return (index - extent[2 * axis] + 0.5) / image->GetDimensions()[axis];
}
}

TEST_CASE("A clipping plane keeps the side that its normal points to")
{
  std::mt19937 generator(31);
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    const Vector3 onPlane = RandomPointInBox(geometry, generator);
    Vector3 origin = volume.ToWorld(onPlane);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(0.6, -0.64, 0.48);
    const std::array<double, 4> inTexture = geometry.GetPlane(plane);
    CHECK(GetLength({ inTexture[0], inTexture[1], inTexture[2] }) == Approx(1.0));
    // Rounding of coordinates up to 1e5 over a side of at least 2e-3.
    CHECK(GetHeight(inTexture, onPlane) == Approx(0.0).margin(1e-8));
    for (int sample = 0; sample < 20; ++sample)
    {
      const Vector3 texture = RandomPointInBox(geometry, generator);
      Vector3 world = volume.ToWorld(texture);
      const double height = GetHeight(inTexture, texture);
      if (std::abs(height) > 1e-8)
      {
        CHECK((height > 0.0) == (plane->EvaluateFunction(world.data()) > 0.0));
      }
    }
  }
}

TEST_CASE("Cropping planes lie at multiples of the spacing from the origin")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const double* spacing = volume.image->GetSpacing();
    const double* origin = volume.image->GetOrigin();
    const int* extent = volume.image->GetExtent();
    double planes[6];
    Vector3 expected[2];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        const double index = extent[2 * axis] + 0.25 + 3.5 * side;
        planes[2 * axis + side] = origin[axis] + index * spacing[axis];
        expected[side][axis] = ToTexture(volume.image, axis, index);
      }
    }
    Vector3 low;
    Vector3 high;
    ComputeCroppingPlanes(volume.image, planes, low, high);
    // Rounding at the origin 1e5, or at 10 with voxels of 1e-3.
    CHECK(GetDistance(low, expected[0]) <= 1e-9);
    CHECK(GetDistance(high, expected[1]) <= 1e-9);
  }
}

TEST_CASE("Cropping planes given in the wrong order are put in order")
{
  const PlacedVolume volume = MakePlacedVolumes().front();
  const double planes[6] = { 8.0, 2.0, 1.0, 3.0, 9.5, 4.5 };
  Vector3 low;
  Vector3 high;
  ComputeCroppingPlanes(volume.image, planes, low, high);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [least, greatest] = std::minmax(planes[2 * axis], planes[2 * axis + 1]);
    CHECK(low[axis] == Approx(ToTexture(volume.image, axis, least)));
    CHECK(high[axis] == Approx(ToTexture(volume.image, axis, greatest)));
  }
}
