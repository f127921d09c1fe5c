/**
 * @file    LightVisibility.h
 * @brief   how much of a light gets through matter to a sample
 */

#ifndef LightVisibility_h
#define LightVisibility_h

#include "LightSource.h"
#include "VolumeMatter.h"

namespace penumbra::reference
{

struct Visibility
{
  double Share = 1.0;
  /// Bound.
  double Error = 0.0;
  /// Of a hard shadow: by how much the optical depth exceeds what makes the shadow.
  double Margin = 0.0;
};

/**
 * Along the shadow ray from a sample towards the light, which starts the light's bias away.
 * `position` is in voxel indices, `toLight` in the world, of unit length. The tolerance is of the
 * share; of a hard shadow it is one of where its edge is.
 */
Visibility GetVisibility(const VolumeMatter& matter, const LightSource& light,
  const vtkVector3d& position, const vtkVector3d& toLight, double tolerance);

}

#endif
