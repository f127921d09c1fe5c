/**
 * @file SceneOptions.h
 * @brief Everything that a scene may need or not, as one value to build it from.
 */
#ifndef SceneOptions_h
#define SceneOptions_h

#include "IlluminatedScene.h"
#include "LightingRequirements.h"

#include <memory>

namespace penumbra
{
struct SceneOptions
{
  OpticalModel optics = OpticalModel::SingleScattering;
  ReflectionModel reflection = ReflectionModel::Phong;
  GradientEstimator gradient = GradientEstimator::CentralDifferences;
  bool gradientTexture = true;
  bool noiseFading = true;
  /// As many lights of each kind and shadow state.
  std::array<std::array<int, NumberOfShadowKinds>, NumberOfLightKinds> lights{};
  ShadowTechnique technique = ShadowTechnique::Rays;
  /// Of techniques that keep shadows; up to 8 are marched in a row.
  int nearShadowSteps = 4;
  bool diffuse = true;
  bool specular = true;
  bool twoSided = true;
  bool attenuation = true;
  bool gradientOpacity = true;
  int clippingPlanes = 6;
  CroppingKind cropping = CroppingKind::Regions;
  bool mask = true;
  TransferFunctionLookup opacity = TransferFunctionLookup::Points;
  /// Of a table: it jumps within a hundredth of the data's range.
  bool steep = false;
  /// Of lit steps: they are short enough for it.
  bool halvedSteps = true;
  /// Half of the volume is empty.
  bool emptySpace = true;
  /// Draws to a buffer of its own first.
  bool gathering = true;

  /// What the scene must report that it needs.
  LightingRequirements Expected() const;

private:
  void ExpectReflection(LightingRequirements& needs) const;
};

/// A ball of 12^3 voxels, with as much empty space behind it, on 32 x 32 pixels.
std::unique_ptr<IlluminatedScene> MakeScene();

/// Makes a scene of MakeScene() the one of these options, whatever it was before.
void SetOptions(IlluminatedScene& scene, const SceneOptions& options);
}

#endif
