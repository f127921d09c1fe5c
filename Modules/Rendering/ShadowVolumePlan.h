/**
 * @file    ShadowVolumePlan.h
 * @brief   how many texels and lights a shadow volume holds
 *
 * A shadow volume is a 3D texture over the visible box, from face to face, with the visibility of
 * up to four lights in a texel's components. Further lights take blocks of slices behind each
 * other. What exceeds the memory allowed is made coarser; lights beyond the largest texture are not
 * held.
 */

#ifndef ShadowVolumePlan_h
#define ShadowVolumePlan_h

#include "PenumbraRenderingModule.h" // For export macro
#include "VolumePlacement.h"

#include <array>
#include <cstddef>

namespace penumbra
{

struct ShadowVolumeTask
{
  Vector3 Voxels{};                    ///< length of the visible box along each axis, in voxels
  Vector3 VoxelEdges{ 1.0, 1.0, 1.0 }; ///< relative to the smallest
  /// Texels a smallest voxel edge, more than 0. Texels are as long along every axis, as far as a
  /// long voxel need have no more than two of them.
  double Resolution = 1.0;
  int Lights = 0;      ///< with a shadow
  int LargestSize = 0; ///< of a 3D texture along one axis
  std::size_t LargestBytes = 0;
};

struct PENUMBRARENDERING_EXPORT ShadowVolumePlan
{
  std::array<int, 3> Texels{}; ///< of a block, 2 or more along each axis
  int Components = 0;          ///< 1, 2 or 4
  int Blocks = 0;
  int Lights = 0;          ///< that it holds, the first ones
  double Resolution = 0.0; ///< texels a voxel
  bool Coarsened = false;  ///< the resolution is less than asked

  std::size_t GetBytes() const;
  int GetNumberOfSlices() const { return this->Blocks * this->Texels[2]; }
};

PENUMBRARENDERING_EXPORT ShadowVolumePlan PlanShadowVolume(const ShadowVolumeTask& task);

}

#endif
