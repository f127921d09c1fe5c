/**
 * @file MakeLight.h
 * @brief A white light of any kind and shadow state, that no test has to describe again.
 */
#ifndef MakeLight_h
#define MakeLight_h

#include "LightingRequirements.h"
#include "vtkVolumeLight.h"

#include <vtkSmartPointer.h>

namespace penumbra
{
/// Shines from (30, 40, 50) towards (5, 5, 5), a spot light within 40 degrees.
inline vtkSmartPointer<vtkVolumeLight> MakeLight(LightKind kind, ShadowKind shadow)
{
  auto light = vtkSmartPointer<vtkVolumeLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(30.0, 40.0, 50.0);
  light->SetFocalPoint(5.0, 5.0, 5.0);
  light->SetPositional(kind != LightKind::Directional);
  light->SetConeAngle(kind == LightKind::Spot ? 40.0 : 90.0);
  light->SetShadow(static_cast<int>(shadow));
  return light;
}
}

#endif
