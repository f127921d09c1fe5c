/**
 * @file    ScalarNoise.h
 * @brief   how much of a volume's gradient is noise
 */

#ifndef ScalarNoise_h
#define ScalarNoise_h

#include "LightingRequirements.h" // For GradientEstimator

#include "vtkVector.h"

namespace penumbra::reference
{

class ScalarField;

/**
 * The root mean square of the magnitude of the gradient that white noise has by itself, in scalar
 * units per length. The noise's standard deviation is the median of the absolute second
 * differences along the axes, over .6745 sqrt(6) (Immerkaer 1996); those that touch a voxel of the
 * smallest value do not count.
 */
double GetGradientNoise(
  const ScalarField& field, const vtkVector3d& spacing, GradientEstimator estimator);

}

#endif
