/**
 * @file    Medium.h
 * @brief   the matter that shadow rays pass
 *
 * A ray is cut into steps, the last of them shorter, and sampled in the middle of each. A step of
 * length h adds g s h to the optical depth, with the extinction s = -ln(1 - min(a, 1 - 2^-24)) / D
 * of the opacity a per unit distance D, and the gradient opacity g. Where a mask hides a part of a
 * step, the step counts by what is left. Opacities are looked up within FunctionLookup's
 * tolerances.
 */

#ifndef Medium_h
#define Medium_h

#include "LightingRequirements.h"
#include "ShadowRay.h"

#include <memory>

class vtkDataArray;
class vtkVolumeProperty;

namespace penumbra
{

struct UsableScalars;

struct MediumDescription
{
  VolumeFrames Frames;
  /// Opacity functions, unit distance and interpolation.
  vtkVolumeProperty* Property = nullptr;
  GradientEstimator Estimator = GradientEstimator::CentralDifferences;
  vtkDataArray* Mask = nullptr; ///< may be null
  double SampleDistance = 1.0;  ///< in the own frame
};

class Medium
{
public:
  virtual ~Medium() = default;

  /// Integral of the extinction along the ray, or something above largestDepth as soon as the
  /// integral is.
  virtual double ComputeOpticalDepth(const ShadowRay& ray, double largestDepth) const = 0;
};

/// The scalars must outlive the medium.
std::unique_ptr<const Medium> MakeMedium(
  const UsableScalars& scalars, const MediumDescription& description);

}

#endif
