/**
 * @file    ReferenceScenes.h
 * @brief   scenes whose pictures are known in closed form
 */

#ifndef ReferenceScenes_h
#define ReferenceScenes_h

#include "SyntheticVolumes.h"

#include <ReferenceIntegrator.h>

#include <vtkVolumeLight.h>
#include <vtkVolumeMaterial.h>

#include <array>
#include <utility>
#include <vector>

namespace penumbra
{

using OpacityPoints = std::vector<std::pair<double, double>>;

/// White, linearly interpolated, not shaded; diffuse light only where it is.
vtkSmartPointer<vtkVolumeMaterial> MakeMaterial(const OpacityPoints& opacity, double unitDistance);

/// Seen from far along `direction`, in parallel projection, with `focalPoint` in the picture's
/// middle; the picture is 2 `scale` high.
vtkSmartPointer<vtkCamera> MakeParallelCamera(
  const Point& focalPoint, const Point& direction, double scale = 10.0);

/// A scene of one pixel, in whose middle is the volume's.
ReferenceScene MakeScene(
  vtkImageData* volume, vtkVolumeProperty* property, const Point& direction = { 0.0, 0.0, -1.0 });

/// In the middle of the picture.
ReferencePixel ComputeMiddle(const ReferenceScene& scene, double tolerance = 0.05);

/// White; no ambient light; no shadow.
vtkSmartPointer<vtkVolumeLight> MakeDirectionalLight(const Point& direction);
vtkSmartPointer<vtkVolumeLight> MakePointLight(const Point& position);

/**
 * An opaque white plane, z = 5, of normal +z, seen from above; 20 wide about x = y = 0. Its layer
 * that is seen is less than 1e-6 thick: a pixel's colour is that of the plane.
 */
ReferenceScene MakePlaneScene();

/// Of the plane's colour at a point: red, green and blue.
std::array<double, 3> ComputePlane(ReferenceScene scene, double x, double y);

}

#endif
