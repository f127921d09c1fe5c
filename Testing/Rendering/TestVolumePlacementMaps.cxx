#include "Catch.h"
#include "PlacedVolume.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
// Rounding of doubles, a few operations on coordinates of this size.
double ErrorAt(const Vector3& place)
{
  return 1e-13 * (1.0 + GetLength(place));
}
}

TEST_CASE("Texture coordinates are where VTK's own maps say")
{
  std::mt19937 generator(30);
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    for (int sample = 0; sample < 20; ++sample)
    {
      const Vector3 texture = RandomPointInBox(geometry, generator);
      const Vector3 own = volume.ToOwn(texture);
      const Vector3 world = volume.ToWorld(texture);
      CHECK(GetDistance(MultiplyPoint(geometry.TextureToOwn, texture), own) <= ErrorAt(own));
      CHECK(GetDistance(MultiplyPoint(geometry.TextureToWorld, texture), world) <= ErrorAt(world));
      // Back: the error in the world by the length of a side there, at least 2e-3.
      CHECK(GetDistance(MultiplyPoint(geometry.WorldToTexture, world), texture) <=
        1e3 * ErrorAt(world));
    }
  }
}

TEST_CASE("The box runs from the first to the last voxel centre")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    const int* extent = volume.image->GetExtent();
    Vector3 first;
    Vector3 last;
    for (int axis = 0; axis < 3; ++axis)
    {
      // A single slice is one spacing thick, half to each side.
      const double margin = extent[2 * axis] == extent[2 * axis + 1] ? 0.5 : 0.0;
      first[axis] = extent[2 * axis] - margin;
      last[axis] = extent[2 * axis + 1] + margin;
    }
    Vector3 firstInOwn;
    Vector3 lastInOwn;
    volume.image->TransformContinuousIndexToPhysicalPoint(first.data(), firstInOwn.data());
    volume.image->TransformContinuousIndexToPhysicalPoint(last.data(), lastInOwn.data());
    CHECK(GetDistance(MultiplyPoint(geometry.TextureToOwn, geometry.FullBoxLow), firstInOwn) <=
      ErrorAt(firstInOwn));
    CHECK(GetDistance(MultiplyPoint(geometry.TextureToOwn, geometry.FullBoxHigh), lastInOwn) <=
      ErrorAt(lastInOwn));
    CHECK(geometry.BoxLow == geometry.FullBoxLow);
    CHECK(geometry.BoxHigh == geometry.FullBoxHigh);
  }
}

TEST_CASE("Spacings and the diagonal are measured in the volume's own frame")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    VolumePlacement geometry = volume.Geometry();
    const double* spacing = volume.image->GetSpacing();
    CHECK(geometry.SmallestSpacing == Approx(*std::min_element(spacing, spacing + 3)));
    CHECK(geometry.MeanSpacing == Approx((spacing[0] + spacing[1] + spacing[2]) / 3.0));
    // Of a rectangular box all diagonals are equally long. Half of the box has half of them.
    const double diagonal =
      GetDistance(volume.ToOwn(geometry.FullBoxLow), volume.ToOwn(geometry.FullBoxHigh));
    CHECK(geometry.GetDiagonal() == Approx(diagonal).epsilon(1e-9));
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.BoxLow[axis] = 0.5 * (geometry.BoxLow[axis] + geometry.BoxHigh[axis]);
    }
    CHECK(geometry.GetDiagonal() == Approx(0.5 * diagonal).epsilon(1e-9));
  }
}

TEST_CASE("A volume without an extent in the world has no geometry")
{
  const PlacedVolume volume = MakePlacedVolumes().front();
  vtkNew<vtkMatrix4x4> flat;
  flat->SetElement(1, 1, 0.0);
  VolumePlacement geometry;
  CHECK_FALSE(ComputeVolumePlacement(volume.image, flat, geometry));
  flat->SetElement(1, 1, std::nan(""));
  CHECK_FALSE(ComputeVolumePlacement(volume.image, flat, geometry));
}

TEST_CASE("Normalized vectors have the length 1, and 0 stays 0")
{
  CHECK(Normalized({ 0.0, 0.0, 0.0 }) == Vector3{ 0.0, 0.0, 0.0 });
  CHECK(Normalized({ 0.0, -3.0, 4.0 })[1] == Approx(-0.6));
  CHECK(GetLength(Normalized({ 1e-200, 2e-200, -1e-200 })) == Approx(1.0));
  CHECK(GetLength(Normalized({ 1e200, 2e200, -1e200 })) == Approx(1.0));
}
