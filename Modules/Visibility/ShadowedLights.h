/**
 * @file    ShadowedLights.h
 * @brief   the lights that cast shadows, as rays from points of the volume towards them
 */

#ifndef ShadowedLights_h
#define ShadowedLights_h

#include "LightingRequirements.h"
#include "ShadowRay.h"

#include <string>
#include <vector>

class vtkLightCollection;
class vtkVolumeLight;

namespace penumbra
{

struct ShadowedLight
{
  int Index = 0; ///< among all lights of the collection
  LightKind Kind = LightKind::Directional;
  bool Headlight = false;
  bool Hard = false;
  /// Length in the own frame between a point and the start of its ray.
  double Bias = 0.0;
  /// Optical depth beyond which nothing of the light is left: the threshold's for a hard shadow.
  double LargestDepth = 0.0;
  /// Directional lights: towards the light, per length of the own frame. Others: where they are.
  Vector3 DirectionOrPosition{};

  /// "Visibility", the index and the kind: Directional, Headlight, Point or Spot.
  std::string GetName() const;
  /// From a point towards the light, from Bias on to the light. Empty where there is no direction.
  ShadowRay MakeRay(const VolumeFrames& frames, const Vector3& point) const;
  /// Of the light at the near end of that much optical depth, 0 to 1.
  double GetVisibility(double opticalDepth) const;
};

/// The vtkVolumeLights that are on and have a shadow, in the collection's order.
std::vector<vtkVolumeLight*> FindShadowedLights(vtkLightCollection* lights);

/**
 * The same, prepared. cameraDirection is a headlight's, in the world. A soft shadow that leaves
 * less than negligibleVisibility of the light is complete.
 */
std::vector<ShadowedLight> MakeShadowedLights(vtkLightCollection* lights,
  const VolumeFrames& frames, const Vector3& cameraDirection, double negligibleVisibility);

}

#endif
