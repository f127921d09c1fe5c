/**
 * @file    SceneCamera.h
 * @brief   the camera of a scene: what it may be, what it is by default, and its clipping range
 */

#ifndef SceneCamera_h
#define SceneCamera_h

#include "SceneDescription.h"

class vtkCamera;

namespace penumbra
{

class VolumeBox;

/**
 * @throw InputError where what is given of the camera has no direction of view, or one along
 * viewUp.
 */
void CheckView(const CameraDescription& camera);

/**
 * Fills in what is not given: a view of the whole box from the front, a little from the left and
 * from above, z up. `aspect` is the picture's width over its height.
 * @throw InputError where what is given does not go with the box.
 */
void ResolveCamera(CameraDescription& camera, const VolumeBox& box, double aspect);

/// `description` must be resolved.
void ApplyCamera(const CameraDescription& description, vtkCamera* camera);

/**
 * A clipping range that the box lies well within, as far as it is before the eye.
 */
void FitClippingRange(vtkCamera* camera, const VolumeBox& box);

/// The camera's axes in the world, of unit length: to the right, up and towards the viewer.
struct CameraAxes
{
  explicit CameraAxes(vtkCamera* camera);

  Vector3 Right;
  Vector3 Up;
  Vector3 Backward;

  Vector3 ToWorld(const Vector3& direction) const;
};

}

#endif
