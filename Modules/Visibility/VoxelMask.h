/**
 * @file    VoxelMask.h
 * @brief   a binary mask: voxels whose value is 0 hide the matter nearest to them
 */

#ifndef VoxelMask_h
#define VoxelMask_h

#include "VolumeFrames.h"

#include <vector>

class vtkDataArray;

namespace penumbra
{

class VoxelMask
{
public:
  /// One value a voxel, x fastest.
  VoxelMask(vtkDataArray* values, const std::array<int, 3>& dimensions);

  /// How much of the way between two positions, in voxel indices, is not hidden: 0 to 1, exact.
  double GetVisiblePart(const Vector3& from, const Vector3& to) const;

private:
  bool IsVisible(const std::array<double, 3>& voxel) const;

  std::array<int, 3> Dimensions;
  std::vector<bool> Visible;
};

}

#endif
