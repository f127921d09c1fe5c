/**
 * @file    EnvironmentReflection.h
 * @brief   what matter reflects of its surroundings
 */

#ifndef EnvironmentReflection_h
#define EnvironmentReflection_h

#include "LightSource.h" // For Rgb

#include "vtkVector.h"

class vtkVolumeProperty;

namespace penumbra::reference
{

class EnvironmentReflection
{
public:
  EnvironmentReflection(vtkVolumeProperty*, double) {}

  Rgb GetDiffuse(const vtkVector3d&) const { return {}; }
  Rgb GetSpecular(const vtkVector3d&) const { return {}; }
  Rgb GetMean() const { return {}; }
  double GetError() const { return 0.0; }
};

}

#endif
