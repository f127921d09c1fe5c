#include "OutputGrid.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
int CountVoxels(const ImageGeometry& geometry, int axis)
{
  return geometry.Extent[2 * axis + 1] - geometry.Extent[2 * axis] + 1;
}

double GetBoxLength(int voxels)
{
  return voxels > 1 ? voxels - 1 : 1;
}
}

//------------------------------------------------------------------------------
int GetNumberOfPoints(int voxels, double resolution)
{
  if (voxels <= 1 || !(resolution > 0.0))
  {
    return std::max(voxels, 0);
  }
  return static_cast<int>(std::lround((voxels - 1) * resolution)) + 1;
}

//------------------------------------------------------------------------------
ImageGeometry ComputeOutputGeometry(
  const ImageGeometry& volume, const std::array<int, 3>& numberOfPoints)
{
  ImageGeometry output = volume;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int voxels = CountVoxels(volume, axis);
    const int points = numberOfPoints[axis];
    if (points == voxels)
    {
      continue;
    }
    output.Extent[2 * axis] = 0;
    output.Extent[2 * axis + 1] = points - 1;
    output.Spacing[axis] *= GetBoxLength(voxels) / GetBoxLength(points);
    const double shift =
      volume.Spacing[axis] * (volume.Extent[2 * axis] + GetIndexOfPoint(0, points, voxels));
    for (int row = 0; row < 3; ++row)
    {
      output.Origin[row] += volume.Direction[3 * row + axis] * shift;
    }
  }
  return output;
}

//------------------------------------------------------------------------------
double GetIndexOfPoint(int point, int numberOfPoints, int voxels)
{
  const double low = voxels > 1 ? 0.0 : -0.5;
  const double length = GetBoxLength(voxels);
  if (numberOfPoints == 1)
  {
    return low + 0.5 * length;
  }
  return low + std::min(length * point / (numberOfPoints - 1), length);
}

}
