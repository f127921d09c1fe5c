/**
 * @file    VolumeFrame.h
 * @brief   where a volume's voxels are, in its own frame and in the world
 *
 * Three frames: voxel indices i, counted from 0 whatever the extent is; the volume's own frame q =
 * origin + direction * (index * spacing); the world x, where the actor's matrix takes q. Lengths
 * that belong to the matter are measured in the own frame.
 */

#ifndef VolumeFrame_h
#define VolumeFrame_h

#include "vtkVector.h"

#include <array>

class vtkImageData;
class vtkMatrix4x4;

namespace penumbra::reference
{

/// Row by row.
using Matrix3 = std::array<vtkVector3d, 3>;

vtkVector3d Multiply(const Matrix3& matrix, const vtkVector3d& vector);
vtkVector3d MultiplyTransposed(const Matrix3& matrix, const vtkVector3d& vector);

class VolumeFrame
{
public:
  /// A null matrix is the identity.
  VolumeFrame(vtkImageData* volume, vtkMatrix4x4* actor);

  /// False: the volume is flat in the world, and nothing else here holds.
  bool IsInvertible() const { return this->Invertible; }

  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }
  /// The volume's box in indices: an axis of one voxel is one thick.
  vtkVector3d GetLowest() const;
  vtkVector3d GetHighest() const;

  vtkVector3d ToWorld(const vtkVector3d& index) const;
  vtkVector3d ToIndex(const vtkVector3d& world) const;
  vtkVector3d DirectionToIndex(const vtkVector3d& worldDirection) const;
  /// Of a vector in the own frame.
  vtkVector3d OwnToWorld(const vtkVector3d& ownVector) const;
  /// Length in the own frame of a vector in indices.
  double GetOwnLength(const vtkVector3d& indexVector) const;

  /// A gradient is covariant: from scalar units per voxel to scalar units per length.
  vtkVector3d GradientToWorld(const vtkVector3d& perVoxel) const;
  vtkVector3d GradientToOwn(const vtkVector3d& perVoxel) const;

  /// So that normal . (world - world of index 0) is the result . index.
  vtkVector3d NormalToIndex(const vtkVector3d& worldNormal) const;

  /// The index along an axis at which origin + index * spacing has this value.
  double ToIndex(double alongAxis, int axis) const;

  double GetSmallestSpacing() const;
  double GetMeanSpacing() const;
  const vtkVector3d& GetSpacing() const { return this->Spacing; }

private:
  std::array<int, 3> Dimensions{};
  std::array<int, 3> First{};
  vtkVector3d Origin;
  vtkVector3d Spacing;
  bool Invertible = false;
  Matrix3 Actor;
  Matrix3 OwnFromIndex;
  Matrix3 IndexFromOwn;
  Matrix3 WorldFromIndex;
  Matrix3 IndexFromWorld;
  /// Where index (0, 0, 0) is in the world.
  vtkVector3d WorldOfFirst;
};

}

#endif
