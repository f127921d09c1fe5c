#include "VoxelMask.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
double GetNearestVoxel(double position)
{
  return std::floor(position + 0.5);
}

// The border of the voxel in the direction of travel, as a part of the way.
double GetPartToBorder(double from, double to, double voxel)
{
  if (from == to)
  {
    return 1.0;
  }
  const double border = to > from ? voxel + 0.5 : voxel - 0.5;
  return (border - from) / (to - from);
}
}

//------------------------------------------------------------------------------
VoxelMask::VoxelMask(vtkDataArray* values, const std::array<int, 3>& dimensions)
  : Dimensions(dimensions)
  , Visible(values->GetNumberOfTuples())
{
  for (vtkIdType voxel = 0; voxel < values->GetNumberOfTuples(); ++voxel)
  {
    this->Visible[voxel] = values->GetComponent(voxel, 0) != 0.0;
  }
}

//------------------------------------------------------------------------------
bool VoxelMask::IsVisible(const std::array<double, 3>& voxel) const
{
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const double inside = std::clamp(voxel[axis], 0.0, this->Dimensions[axis] - 1.0);
    index = index * this->Dimensions[axis] + static_cast<std::size_t>(inside);
  }
  return this->Visible[index];
}

//------------------------------------------------------------------------------
// From voxel to voxel, each time across the border that comes first.
double VoxelMask::GetVisiblePart(const Vector3& from, const Vector3& to) const
{
  Vector3 voxel;
  std::transform(from.begin(), from.end(), voxel.begin(), GetNearestVoxel);
  double visible = 0.0;
  double begin = 0.0;
  while (begin < 1.0)
  {
    int next = 0;
    double end = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double border = GetPartToBorder(from[axis], to[axis], voxel[axis]);
      next = border < end ? axis : next;
      end = std::min(end, border);
    }
    visible += this->IsVisible(voxel) ? std::max(end - begin, 0.0) : 0.0;
    voxel[next] += to[next] > from[next] ? 1.0 : -1.0;
    begin = std::max(begin, end);
  }
  return visible;
}

}
