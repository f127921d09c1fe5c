/**
 * @class   VolumeBox
 * @brief   where a volume lies in the world
 *
 * The box runs from the first to the last voxel centre along each axis; an axis with a single voxel
 * is one spacing thick, half to each side. VTK's bounds of a volume mapper are not that box once
 * there are a direction matrix, a transform or cropping.
 */

#ifndef VolumeBox_h
#define VolumeBox_h

#include "Vector3.h"

#include <array>

class vtkImageData;

namespace penumbra
{

class VolumeBox
{
public:
  /// `transform` is row-major and affine.
  VolumeBox(vtkImageData* image, const std::array<double, 16>& transform);

  const std::array<Vector3, 8>& GetCorners() const { return this->Corners; }
  Vector3 GetCenter() const;

private:
  std::array<Vector3, 8> Corners;
};

/// Smallest of the three distances between voxel centres, and their mean.
///@{
double SmallestSpacing(vtkImageData* image);
double MeanSpacing(vtkImageData* image);
///@}

}

#endif
