/**
 * @file    MaterialUniforms.h
 * @brief   how matter reflects light, as the shader takes it
 */

#ifndef MaterialUniforms_h
#define MaterialUniforms_h

#include "VolumePlacement.h"

#include <array>

class vtkShaderProgram;
class vtkVolumeProperty;

namespace penumbra
{

struct MaterialUniforms
{
  /// What they mean stands at the top of each Reflection*.glsl.
  std::array<double, 4> Reflection{};
  Vector3 IndexOfRefraction{};
  Vector3 PreferredDirection{}; ///< unit, world
  double DiffuseFactor = 0.0;
  double SpecularFactor = 0.0;

  /// From differences of the scalar texture's values per voxel to multiples of k s,
  /// FadingNoise.glsl.
  Matrix3 GradientToNoise{};
  double FadedReflection = 0.0;

  void Set(vtkShaderProgram* program) const;
};

/// All but what noise fading takes. Numbers that are not finite count as the model's defaults.
MaterialUniforms MakeMaterialUniforms(
  vtkVolumeProperty* property, const VolumePlacement& placement);

}

#endif
