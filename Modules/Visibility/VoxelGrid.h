/**
 * @file    VoxelGrid.h
 * @brief   which voxels surround a position, and interpolation between them
 *
 * Positions are voxel indices, counted from the first voxel; beyond the outermost voxel centres
 * they count as the nearest point between them.
 */

#ifndef VoxelGrid_h
#define VoxelGrid_h

#include "VolumeFrames.h"

#include "vtkType.h"

#include <algorithm>

namespace penumbra
{

/// The eight voxels around a position; along an axis of a single voxel two are the same.
struct VoxelCell
{
  std::array<int, 3> Index; ///< of the lowest
  std::array<double, 3> Fraction;
  vtkIdType Voxel; ///< the lowest
};

class VoxelGrid
{
public:
  VoxelGrid(const std::array<int, 3>& dimensions, bool nearest)
    : Nearest(nearest)
  {
    vtkIdType stride = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Last[axis] = dimensions[axis] - 1;
      this->LastCell[axis] = std::max(dimensions[axis] - 2, 0);
      this->Strides[axis] = stride;
      this->Steps[axis] = dimensions[axis] > 1 ? stride : 0;
      stride *= dimensions[axis];
    }
  }

  VoxelCell Locate(const Vector3& position) const
  {
    VoxelCell cell;
    cell.Voxel = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double inside = std::min(std::max(position[axis], 0.0), this->Last[axis]);
      const int index = std::min(static_cast<int>(inside), this->LastCell[axis]);
      const double fraction = inside - index;
      cell.Index[axis] = index;
      cell.Fraction[axis] = !this->Nearest ? fraction : fraction < 0.5 ? 0.0 : 1.0;
      cell.Voxel += index * this->Strides[axis];
    }
    return cell;
  }

  /// One of several components of the values at the voxels, between them.
  template <int Components = 1, typename Value>
  double Interpolate(const Value* values, const VoxelCell& cell, int component = 0) const
  {
    const Value* first = values + Components * cell.Voxel + component;
    const vtkIdType x = Components * this->Steps[0];
    const vtkIdType y = Components * this->Steps[1];
    const vtkIdType z = Components * this->Steps[2];
    const auto [u, v, w] = cell.Fraction;
    const auto alongX = [=](vtkIdType offset)
    { return Mix(static_cast<double>(first[offset]), static_cast<double>(first[offset + x]), u); };
    return Mix(Mix(alongX(0), alongX(y), v), Mix(alongX(z), alongX(y + z), v), w);
  }

private:
  // Exact where both are equal.
  static double Mix(double a, double b, double share) { return a + share * (b - a); }

  bool Nearest;
  std::array<double, 3> Last;
  std::array<int, 3> LastCell;
  std::array<vtkIdType, 3> Strides;
  std::array<vtkIdType, 3> Steps;
};

}

#endif
