/**
 * @file    VisibilityScene.h
 * @brief   all that visibility depends on, and what of it cannot be computed
 */

#ifndef VisibilityScene_h
#define VisibilityScene_h

#include "LightingRequirements.h"
#include "UsableScalars.h"
#include "VisibilityTask.h"

#include <string>

class vtkDataArray;
class vtkImageData;
class vtkLightCollection;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkVolumeProperty;

namespace penumbra
{

/// As vtkVolumeVisibilityFilter documents it. All but the volume may be null.
struct VisibilityScene
{
  vtkImageData* Volume = nullptr;
  vtkDataArray* Scalars = nullptr; ///< at the volume's points
  vtkImageData* Mask = nullptr;
  vtkVolumeProperty* Property = nullptr;
  vtkLightCollection* Lights = nullptr;
  Vector3 CameraDirection{};
  vtkMatrix4x4* Matrix = nullptr;
  vtkPlaneCollection* ClippingPlanes = nullptr;
  const double* CroppingPlanes = nullptr;
  GradientEstimator Estimator = GradientEstimator::CentralDifferences;
  double SampleDistance = 0.0;
  double NegligibleVisibility = 0.0;
};

/// Why nothing can be computed, in one sentence. Empty where it can.
std::string FindObstacle(const VisibilityScene& scene);

/// What there is to do, but for the points. The scene must have no obstacle; the scalars must
/// outlive the task.
VisibilityTask MakeVisibilityTask(const VisibilityScene& scene, const UsableScalars& scalars);

}

#endif
