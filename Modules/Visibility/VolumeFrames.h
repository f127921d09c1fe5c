/**
 * @file    VolumeFrames.h
 * @brief   where a volume is, in voxels, in its own lengths and in the world
 *
 * Rays are marched in voxel indices, counted from the volume's first voxel whatever its extent, and
 * measured in the volume's own lengths (before the actor's matrix). Lights and clipping planes come
 * from the world. The volume's box runs from the first to the last voxel centre; along an axis with
 * a single voxel it is one spacing thick, half to each side.
 */

#ifndef VolumeFrames_h
#define VolumeFrames_h

#include <array>

class vtkImageData;
class vtkMatrix4x4;
class vtkPlane;

namespace penumbra
{

using Vector3 = std::array<double, 3>;
/// Row-major, acting on columns.
using Matrix3 = std::array<double, 9>;

struct VolumeFrames
{
  std::array<int, 3> Dimensions{};
  Matrix3 IndexToOwn{};   ///< of differences: the direction matrix times the spacing
  Matrix3 IndexToWorld{}; ///< of differences
  Matrix3 WorldToIndex{}; ///< of differences
  Vector3 FirstVoxel{};   ///< in the world
  Vector3 BoxLow{};       ///< in indices
  Vector3 BoxHigh{};
  double SmallestSpacing = 1.0;
  double MeanSpacing = 1.0;

  Vector3 GetIndexPosition(const Vector3& world) const;
  /// Length in the own frame of a difference of indices.
  double GetOwnLength(const Vector3& index) const;
  /// Length in the own frame of the box's longest diagonal.
  double GetDiagonal() const;
  /// Inverse transpose of IndexToOwn: from derivatives along the indices to the gradient in the own
  /// frame.
  Matrix3 GetGradientToOwn() const;
  /// A plane of the world as (a, b, c, d): a i + b j + c k + d is the distance from it in voxels,
  /// positive on the side that its normal points to.
  std::array<double, 4> GetIndexPlane(vtkPlane* plane) const;
};

/// False where the spacing, the direction matrix or the actor's matrix has no inverse. A null
/// matrix is the identity.
bool ComputeVolumeFrames(vtkImageData* image, vtkMatrix4x4* actorMatrix, VolumeFrames& frames);

}

#endif
