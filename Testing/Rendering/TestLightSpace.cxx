#include "Catch.h"
#include "LightSpace.h"
#include "PlacedVolume.h"

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
// Of places that are kept as floats.
constexpr double Rounding = 1e-5;

// Corners, faces and the inside of the box.
std::vector<Vector3> GetPoints(const VolumePlacement& placement)
{
  std::vector<Vector3> points;
  for (const double x : { 0.0, 0.3, 1.0 })
  {
    for (const double y : { 0.0, 0.6, 1.0 })
    {
      for (const double z : { 0.0, 0.5, 1.0 })
      {
        const double part[3] = { x, y, z };
        Vector3 point;
        for (int axis = 0; axis < 3; ++axis)
        {
          point[axis] = placement.BoxLow[axis] +
            part[axis] * (placement.BoxHigh[axis] - placement.BoxLow[axis]);
        }
        points.push_back(point);
      }
    }
  }
  return points;
}

double OwnDistance(const VolumePlacement& placement, const Vector3& a, const Vector3& b)
{
  return GetLength(
    MultiplyDirection(placement.TextureToOwn, { b[0] - a[0], b[1] - a[1], b[2] - a[2] }));
}

std::array<float, 4> MakePlace(const Vector3& where, float positional)
{
  return { static_cast<float>(where[0]), static_cast<float>(where[1]), static_cast<float>(where[2]),
    positional };
}
}

TEST_CASE("Parallel rays keep their place and go as far as own lengths say")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement placement = volume.Geometry();
    const Vector3 towardsLight = { 0.3, -0.8, 0.5 };
    const LightSpace space = ComputeLightSpace(placement, MakePlace(towardsLight, 0.0f));
    CHECK(space.Projection == LightProjection::Parallel);
    Vector3 low = { 1e9, 1e9, 1e9 };
    Vector3 high = { -1e9, -1e9, -1e9 };
    for (const Vector3& point : GetPoints(placement))
    {
      const Vector3 place = MultiplyPoint(space.TextureToLight, point);
      Vector3 nearer;
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], place[axis]);
        high[axis] = std::max(high[axis], place[axis]);
        nearer[axis] = point[axis] + 0.1 * towardsLight[axis];
      }
      const Vector3 moved = MultiplyPoint(space.TextureToLight, nearer);
      const double length = OwnDistance(placement, point, nearer);
      CHECK(std::abs(moved[0] - place[0]) <= Rounding);
      CHECK(std::abs(moved[1] - place[1]) <= Rounding);
      CHECK(place[2] - moved[2] == Approx(length).epsilon(Rounding));
    }
    CHECK(low[0] == Approx(0.0).margin(Rounding));
    CHECK(low[1] == Approx(0.0).margin(Rounding));
    CHECK(low[2] == Approx(0.0).margin(Rounding * high[2]));
    CHECK(space.Nearest == 0.0);
    CHECK(space.Farthest == Approx(high[2]).epsilon(Rounding));
    CHECK(std::max(high[0], high[1]) == Approx(1.0));
  }
}

TEST_CASE("A light far from the box has a map by perspective, one near or inside all around it")
{
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement placement = volume.Geometry();
    Vector3 inside;
    Vector3 far;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double length = placement.BoxHigh[axis] - placement.BoxLow[axis];
      inside[axis] = placement.BoxLow[axis] + 0.4 * length;
      far[axis] = placement.BoxLow[axis] + 4.0 * length;
    }
    const LightSpace around = ComputeLightSpace(placement, MakePlace(inside, 1.0f));
    CHECK(around.Projection == LightProjection::Octahedral);
    const LightSpace before = ComputeLightSpace(placement, MakePlace(far, 1.0f));
    CHECK(before.Projection == LightProjection::Perspective);
    CHECK(around.Nearest == 0.0);
    CHECK(before.Nearest > 0.0);
    for (const Vector3& point : GetPoints(placement))
    {
      const Vector3 place = MultiplyPoint(before.TextureToLight, point);
      const double distance = OwnDistance(placement, far, point);
      CHECK(GetLength(place) == Approx(distance).epsilon(Rounding));
      CHECK(place[2] > 0.0);
      CHECK(distance >= before.Nearest);
      CHECK(distance <= before.Farthest * (1.0 + Rounding));
      CHECK(OwnDistance(placement, inside, point) <= around.Farthest * (1.0 + Rounding));
      const double extent = (1.0 + Rounding) * before.Extent * place[2];
      CHECK(std::max(std::abs(place[0]), std::abs(place[1])) <= extent);
    }
  }
}

TEST_CASE("A light very far away has parallel rays from where it is")
{
  const VolumePlacement placement = MakePlacedVolumes().front().Geometry();
  const Vector3 towards = { 0.3, -0.8, 0.5 };
  Vector3 far;
  for (int axis = 0; axis < 3; ++axis)
  {
    far[axis] = 0.5 * (placement.BoxLow[axis] + placement.BoxHigh[axis]) + 1e7 * towards[axis];
  }
  const LightSpace space = ComputeLightSpace(placement, MakePlace(far, 1.0f));
  const LightSpace parallel = ComputeLightSpace(placement, MakePlace(towards, 0.0f));
  REQUIRE(space.Projection == LightProjection::Parallel);
  for (int i = 0; i < 16; ++i)
  {
    CHECK(space.TextureToLight[i] == Approx(parallel.TextureToLight[i]).margin(1e-4));
  }
}

TEST_CASE("The way back from a light's frame is the inverse")
{
  const VolumePlacement placement = MakePlacedVolumes().front().Geometry();
  const LightSpace space = ComputeLightSpace(placement, MakePlace({ 3.0, 2.0, 1.0 }, 1.0f));
  const Vector3 point = { 0.2, 0.7, 0.4 };
  const Vector3 back =
    MultiplyPoint(space.LightToTexture, MultiplyPoint(space.TextureToLight, point));
  CHECK(GetDistance(back, point) <= Rounding);
}
