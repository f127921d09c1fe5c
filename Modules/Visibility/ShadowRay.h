/**
 * @file    ShadowRay.h
 * @brief   a ray from a point towards a light
 */

#ifndef ShadowRay_h
#define ShadowRay_h

#include "VolumeFrames.h"

namespace penumbra
{

/// Positions are in voxel indices, parameters along the ray are lengths in the volume's own frame.
struct ShadowRay
{
  Vector3 Origin;
  Vector3 Direction;
  double Begin;
  double End;

  Vector3 GetPosition(double length) const
  {
    return { this->Origin[0] + length * this->Direction[0],
      this->Origin[1] + length * this->Direction[1],
      this->Origin[2] + length * this->Direction[2] };
  }
};

}

#endif
