/**
 * @file    GradientVoxels.h
 * @brief   gradients at the voxels, in the volume's own lengths
 *
 * Every estimator is a weighted sum of neighbours, and so is interpolation between voxels: the
 * gradient between voxels by interpolated neighbours is the interpolated gradient of the voxels.
 * Neighbours beyond the volume have the values of the outermost voxels.
 */

#ifndef GradientVoxels_h
#define GradientVoxels_h

#include "LightingRequirements.h"
#include "VolumeFrames.h"

#include <vector>

class vtkDataArray;

namespace penumbra
{

struct GradientVoxels
{
  /// Three a voxel, x fastest: the gradient in the own frame times the mean spacing.
  std::vector<float> Values;
  /// No interpolated gradient is longer.
  double LargestMagnitude = 0.0;
};

GradientVoxels ComputeGradientVoxels(
  vtkDataArray* scalars, const VolumeFrames& frames, GradientEstimator estimator);

}

#endif
