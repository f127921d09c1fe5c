/**
 * @file    ReferenceScene.h
 * @brief   what the reference integrator renders
 *
 * Plain values and VTK's own objects, each with VTK's meaning. Nothing here is changed by
 * rendering.
 */

#ifndef ReferenceScene_h
#define ReferenceScene_h

#include "LightingRequirements.h" // For OpticalModel and GradientEstimator

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <optional>
#include <vector>

namespace penumbra
{

struct ReferenceScene
{
  /// Point scalars, of which the first component counts. Not null.
  vtkSmartPointer<vtkImageData> Volume;
  /// Point scalars of the volume's dimensions; where the nearest voxel's is 0 nothing is seen and
  /// nothing casts a shadow. Null: all is seen.
  vtkSmartPointer<vtkImageData> Mask;
  /// The actor's matrix, affine. One that cannot be inverted shows nothing. Null: identity.
  vtkSmartPointer<vtkMatrix4x4> Transform;
  /// Kept interval of origin + index * spacing along each axis: x, x, y, y, z, z. Empty: all.
  std::optional<std::array<double, 6>> Cropping;
  /// In the world; each keeps the side that its normal points to.
  std::vector<vtkSmartPointer<vtkPlane>> ClippingPlanes;

  /// Transfer functions, unit distance, material and interpolation of the first component; a
  /// vtkVolumeMaterial's reflection model too. Functions are linear between their points, whatever
  /// these say of midpoints, sharpness and colour spaces. Not null.
  vtkSmartPointer<vtkVolumeProperty> Property;
  /// Empty: single scattering where the property's Shade is on, else absorption and emission.
  std::optional<OpticalModel> Optics;
  GradientEstimator Gradient = GradientEstimator::CentralDifferences;

  /// Those that are on count; a plain vtkLight casts no shadow.
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  bool TwoSidedLighting = true;

  /// Perspective or parallel; its clipping range does not count. A parallel ray begins in the plane
  /// of the camera's position. Not null.
  vtkSmartPointer<vtkCamera> Camera;
  /// Width and height of the picture, in pixels.
  std::array<int, 2> Size = { 512, 512 };
  /// Linear red, green, blue.
  std::array<double, 3> Background = { 0.0, 0.0, 0.0 };
};

}

#endif
