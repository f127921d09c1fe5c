/**
 * @file    EnvironmentReflection.h
 * @brief   what matter reflects of its surroundings
 */

#ifndef EnvironmentReflection_h
#define EnvironmentReflection_h

#include "LobeTable.h"

#include <string>

class vtkVolumeMaterial;

namespace penumbra::reference
{

/// Ed(N) = 1/pi integral of E(w) max(N.w, 0) dw, and Es(R), the lobe of the specular power.
class EnvironmentReflection
{
public:
  /// `tolerance` is of a reflected colour. A material without a usable map reflects nothing.
  EnvironmentReflection(vtkVolumeMaterial* material, double tolerance);

  using Result = LobeTable::Result;

  /// Of unit directions; black where they have no length.
  Result GetDiffuse(const vtkVector3d& normal) const;
  Result GetSpecular(const vtkVector3d& mirrored) const;
  /// Of all directions.
  const Rgb& GetMean() const { return this->Mean; }

  /// Why the map cannot be used; empty where it can.
  const std::string& GetFault() const { return this->Fault; }

private:
  std::string Fault;
  Surroundings SeenDiffusely;
  Surroundings SeenSpecularly;
  Rgb Mean;
  LobeTable Diffuse;
  LobeIntegral SpecularLobe;
  LobeTable Specular;
};

}

#endif
