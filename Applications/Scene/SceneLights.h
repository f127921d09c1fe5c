/**
 * @file    SceneLights.h
 * @brief   a scene's lights as VTK's
 */

#ifndef SceneLights_h
#define SceneLights_h

#include "SceneDescription.h"

#include <vtkSmartPointer.h>

class vtkCamera;
class vtkVolumeLight;

namespace penumbra
{

/// A light as described, with position and direction in the world as if its frame were the scene.
vtkSmartPointer<vtkVolumeLight> MakeLight(const LightDescription& description);

/// Makes a light of MakeLight's be as described. What is as it was is not modified.
void ApplyLight(const LightDescription& description, vtkVolumeLight* light);

/**
 * Places a light of the camera's frame in the world. VTK's own camera lights do not serve: their
 * frame begins at the focal point and its unit is the distance from there to the eye.
 */
void PlaceInCameraFrame(
  const LightDescription& description, vtkCamera* camera, vtkVolumeLight* light);

}

#endif
