/**
 * @file    GradientNoise.h
 * @brief   how noisy a volume's scalars are, and its gradients
 *
 * Where a gradient's magnitude is not well above its noise, its direction says nothing.
 */

#ifndef GradientNoise_h
#define GradientNoise_h

#include "LightingRequirements.h"

#include <array>

class vtkDataArray;

namespace penumbra
{

/**
 * Standard deviation of the scalars' noise, in scalar units, taken as white. Second differences
 * f(i-1) - 2 f(i) + f(i+1) along the axes leave out what is linear, and have 6 times the variance
 * of the noise (Immerkaer, "Fast noise variance estimation", 1996); the median of their absolute
 * values is .6745 standard deviations, and edges hardly move it. Those that touch a voxel of the
 * smallest value do not count: it is background, or noise cut off. NaN and infinities count as in
 * GradientField.h. Of whole numbers the result is a multiple of .6; 0 where no difference counts.
 */
double EstimateNoise(vtkDataArray* scalars, const std::array<int, 3>& dimensions);

/// Standard deviation of one component of the gradient, per voxel, from that of the scalars: the
/// root of the sum of the estimator's squared weights.
double GradientNoise(double noise, GradientEstimator estimator);

}

#endif
