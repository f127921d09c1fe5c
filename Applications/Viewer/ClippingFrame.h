/**
 * @file    ClippingFrame.h
 * @brief   the box that a volume is cropped to, and where it is in the world
 */

#ifndef ClippingFrame_h
#define ClippingFrame_h

#include "SceneDescription.h"

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkMatrix4x4;

namespace penumbra
{

/// As VolumeDescription::Cropping: an interval of origin + index * spacing along each axis.
using CroppingBox = std::array<double, 6>;

/// From the first to the last voxel centre, and never without extent.
CroppingBox WholeBox(vtkImageData* image);

/// What is kept of the scene's volume.
CroppingBox KeptBox(const SceneDescription& scene, vtkImageData* image);

/**
 * The box with a side, 0 to 5 for x, x, y, y, z, z, at this place; it stays within the whole, and
 * some of each axis stays within the box.
 */
CroppingBox WithSideAt(const CroppingBox& box, int side, double place, const CroppingBox& whole);

/// From such intervals to the world.
vtkSmartPointer<vtkMatrix4x4> CroppingToWorld(const SceneDescription& scene, vtkImageData* image);

}

#endif
