/**
 * @file    VolumeRay.h
 * @brief   a straight ray through a volume
 */

#ifndef VolumeRay_h
#define VolumeRay_h

#include "VolumeFrame.h"

#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <limits>

namespace penumbra::reference
{

/// Its parameter t, 0 <= t <= Length, is a length in the volume's own frame.
struct VolumeRay
{
  /// In voxel indices.
  vtkVector3d Start;
  /// In voxel indices per length in the volume's own frame.
  vtkVector3d Direction;
  double Length = std::numeric_limits<double>::infinity();

  vtkVector3d At(double t) const { return this->Start + this->Direction * t; }

  /// Leaves out all but `begin` to `end`.
  void Cut(double begin, double end)
  {
    this->Start = this->At(begin);
    this->Length = end - begin;
  }
};

/// Without end. `direction` is in voxel indices, of any length but 0.
inline VolumeRay MakeRay(
  const VolumeFrame& frame, const vtkVector3d& start, const vtkVector3d& direction)
{
  return { start, direction * (1.0 / frame.GetOwnLength(direction)) };
}

}

#endif
