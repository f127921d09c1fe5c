/**
 * @file    VisibleRegion.h
 * @brief   what of a volume is neither clipped nor cropped nor masked
 */

#ifndef VisibleRegion_h
#define VisibleRegion_h

#include "ScalarField.h" // For VoxelIndex
#include "VolumeRay.h"

#include <vector>

namespace penumbra
{
struct ReferenceScene;
}

namespace penumbra::reference
{

class VisibleRegion
{
public:
  VisibleRegion(const ReferenceScene& scene, const VolumeFrame& frame);

  /// Cuts the ray to what is within the box, the cropping and the planes, and returns true; false
  /// where nothing is.
  bool Clip(VolumeRay& ray) const;

  bool HasMask() const { return !this->Mask.empty(); }
  /// Whether the mask hides what is nearest to this voxel.
  bool IsMasked(const VoxelIndex& voxel) const
  {
    return this->Mask[voxel[0] + this->Rows * voxel[1] + this->Slices * voxel[2]] == 0;
  }

private:
  /// Keeps Normal . index + Offset >= 0.
  struct HalfSpace
  {
    vtkVector3d Normal;
    double Offset;
  };

  void AddBox(const ReferenceScene& scene, const VolumeFrame& frame);
  void AddPlanes(const ReferenceScene& scene, const VolumeFrame& frame);
  void AddMask(const ReferenceScene& scene, const VolumeFrame& frame);

  std::vector<HalfSpace> HalfSpaces;
  std::vector<unsigned char> Mask;
  std::ptrdiff_t Rows = 0;
  std::ptrdiff_t Slices = 0;
};

}

#endif
