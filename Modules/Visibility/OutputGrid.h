/**
 * @file    OutputGrid.h
 * @brief   the points at which visibility is computed
 *
 * An image that fills the same box as the volume with more or fewer points. Along an axis with as
 * many points as the volume has voxels both coincide, extent included; along any other the extent
 * begins at 0. A single point lies in the middle.
 */

#ifndef OutputGrid_h
#define OutputGrid_h

#include "VolumeFrames.h"

namespace penumbra
{

/// What the pipeline says of an image before it is there.
struct ImageGeometry
{
  std::array<int, 6> Extent{};
  Vector3 Origin{};
  Vector3 Spacing{};
  Matrix3 Direction{};
};

/// Points along one axis for that many voxels: even, the first and the last in the same places.
int GetNumberOfPoints(int voxels, double resolution);

/// The image of that many points in a volume's box.
ImageGeometry ComputeOutputGeometry(
  const ImageGeometry& volume, const std::array<int, 3>& numberOfPoints);

/// Voxel index, counted from the volume's first voxel, of a point that is the n-th along its axis.
double GetIndexOfPoint(int point, int numberOfPoints, int voxels);

}

#endif
