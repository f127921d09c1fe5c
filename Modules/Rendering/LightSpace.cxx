#include "LightSpace.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra
{
namespace
{
// Diagonals of the box. From a light beyond it rays are parallel within an eighth of a voxel in
// 500; their distances would be floats of less precision than that.
constexpr double LargestDistance = 2000.0;
// Beyond it perspective spends too many texels on the border of its map.
constexpr double LargestExtent = 1.5;

std::vector<Vector3> GetCorners(const VolumePlacement& placement)
{
  std::vector<Vector3> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (corner >> axis & 1) != 0 ? placement.BoxHigh[axis] : placement.BoxLow[axis];
    }
    corners.push_back(point);
  }
  return corners;
}

// Axes at right angles, the third one given.
Matrix3 MakeAxes(const Vector3& third)
{
  Vector3 first;
  Vector3 second;
  vtkMath::Perpendiculars(third.data(), first.data(), second.data(), 0.0);
  return { first[0], first[1], first[2], second[0], second[1], second[2], third[0], third[1],
    third[2] };
}

// From texture coordinates to own lengths from an origin along the axes.
Matrix4 MapToAxes(const VolumePlacement& placement, const Matrix3& axes, const Vector3& origin)
{
  const Matrix4 turn = { axes[0], axes[1], axes[2], 0.0, axes[3], axes[4], axes[5], 0.0, axes[6],
    axes[7], axes[8], 0.0, 0.0, 0.0, 0.0, 1.0 };
  Matrix4 map = Multiply(turn, placement.TextureToOwn);
  const Vector3 at = MultiplyPoint(map, origin);
  for (int row = 0; row < 3; ++row)
  {
    map[4 * row + 3] -= at[row];
  }
  return map;
}

LightSpace MapParallelRays(const VolumePlacement& placement, const Vector3& towardsLight)
{
  const Vector3 own = Normalized(MultiplyDirection(placement.TextureToOwn, towardsLight));
  LightSpace space;
  space.TextureToLight =
    MapToAxes(placement, MakeAxes({ -own[0], -own[1], -own[2] }), placement.BoxLow);
  Vector3 low = { 1e300, 1e300, 1e300 };
  Vector3 high = { -1e300, -1e300, -1e300 };
  for (const Vector3& corner : GetCorners(placement))
  {
    const Vector3 point = MultiplyPoint(space.TextureToLight, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  space.Farthest = high[2] - low[2];
  // One scale for both axes keeps texels square.
  const double span = std::max(high[0] - low[0], high[1] - low[1]);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double scale = axis < 2 ? 1.0 / span : 1.0;
    space.TextureToLight[4 * axis + 3] -= low[axis];
    for (int column = 0; column < 4; ++column)
    {
      space.TextureToLight[4 * axis + column] *= scale;
    }
  }
  return space;
}

LightSpace MapRaysFromPoint(const VolumePlacement& placement, const Vector3& position)
{
  Vector3 toMiddle;
  for (int axis = 0; axis < 3; ++axis)
  {
    toMiddle[axis] = 0.5 * (placement.BoxLow[axis] + placement.BoxHigh[axis]) - position[axis];
  }
  const Vector3 own = MultiplyDirection(placement.TextureToOwn, toMiddle);
  const double distance = GetLength(own);
  if (distance > LargestDistance * placement.GetDiagonal())
  {
    return MapParallelRays(placement, { -toMiddle[0], -toMiddle[1], -toMiddle[2] });
  }
  const Vector3 straight = { 0.0, 0.0, 1.0 };
  LightSpace space;
  space.TextureToLight =
    MapToAxes(placement, MakeAxes(distance > 0.0 ? Normalized(own) : straight), position);
  bool before = true;
  double nearest = 1e300;
  space.Extent = 0.0;
  for (const Vector3& corner : GetCorners(placement))
  {
    const Vector3 point = MultiplyPoint(space.TextureToLight, corner);
    space.Farthest = std::max(space.Farthest, GetLength(point));
    nearest = std::min(nearest, point[2]);
    before = before && point[2] > 0.0;
    if (before)
    {
      space.Extent =
        std::max({ space.Extent, std::abs(point[0]) / point[2], std::abs(point[1]) / point[2] });
    }
  }
  if (before && space.Extent <= LargestExtent)
  {
    space.Projection = LightProjection::Perspective;
    space.Nearest = nearest;
    return space;
  }
  space.Projection = LightProjection::Octahedral;
  return space;
}
}

//------------------------------------------------------------------------------
LightSpace ComputeLightSpace(const VolumePlacement& placement, const std::array<float, 4>& place)
{
  const Vector3 where = { place[0], place[1], place[2] };
  LightSpace space =
    place[3] > 0.0f ? MapRaysFromPoint(placement, where) : MapParallelRays(placement, where);
  Invert(space.TextureToLight, space.LightToTexture);
  return space;
}

}
