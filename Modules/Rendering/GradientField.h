/**
 * @file    GradientField.h
 * @brief   gradients at the voxels of a volume, and their quantization for a texture
 *
 * A gradient is that per voxel, (d f / d index), in scalar units: spacing, direction and the
 * actor's matrix come later. Values outside the volume are those of the outermost voxels; along an
 * axis of a single voxel the derivative is 0. NaN and -Inf count as the smallest finite value, +Inf
 * as the largest. With f+ and f- the values one voxel ahead and behind along the axis (MODEL.md
 * section 3, thesis eq. 22-26):
 *
 *   central   (f+ - f-) / 2
 *   forward   f+ - f
 *   backward  f - f-
 *   Sobel     (sum w f+ - sum w f-) / 44, w the weights of the 3x3 values across the axis
 */

#ifndef GradientField_h
#define GradientField_h

#include "LightingRequirements.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkDataArray;

namespace penumbra
{

/// Of the 3x3 values across the axis of a Sobel difference. Their sum is 22.
constexpr int SobelWeights[3][3] = { { 1, 3, 1 }, { 3, 6, 3 }, { 1, 3, 1 } };

/// Three a voxel, x fastest. What is beyond single precision is infinite.
std::vector<float> ComputeGradientField(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator);

/// Gradients as signed normalized integers: gradient = Scale * value / (127 or 32767). 0 is exact.
struct QuantizedGradientField
{
  int Bits = 8; ///< 8 or 16
  /// Three a voxel, x fastest, without padding; the other vector is empty.
  std::vector<signed char> Values8;
  std::vector<short> Values16;
  /// The largest absolute component. 0 where the volume is constant.
  double Scale = 0.0;
  std::size_t Bytes = 0;
  /// Largest error of a component, in scalar units per voxel.
  double LargestError = 0.0;
  /// Degrees between the exact and the quantized gradient in index space: the mean over the voxels,
  /// weighted by the exact magnitude. A gradient that becomes 0 counts as 90, the mean of a random
  /// direction.
  double MeanAngularError = 0.0;
};

/// Goes over the scalars twice, for the scale and for the values, and holds no other gradients than
/// those of a row per thread.
QuantizedGradientField QuantizeGradientField(vtkDataArray* scalars,
  const std::array<int, 3>& dimensions, GradientEstimator estimator, int bits);

}

#endif
