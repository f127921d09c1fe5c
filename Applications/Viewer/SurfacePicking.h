/**
 * @file    SurfacePicking.h
 * @brief   the point of the volume that is seen at a place of the view
 */

#ifndef SurfacePicking_h
#define SurfacePicking_h

#include "SceneDescription.h"

#include <optional>

class vtkImageData;
class vtkRenderer;

namespace penumbra
{

/**
 * Where a ray has gathered half of full opacity, in the world; nothing where it never does.
 * Cropping and clipping planes are respected. `direction` has any length but 0.
 */
std::optional<Vector3> FindSurface(
  const SceneDescription& scene, vtkImageData* image, const Vector3& eye, const Vector3& direction);

/// The same as seen in a pixel of a renderer's window, from the lower left.
std::optional<Vector3> FindSurfaceAt(const SceneDescription& scene, vtkImageData* image,
  vtkRenderer* renderer, const std::array<double, 2>& pixel);

}

#endif
