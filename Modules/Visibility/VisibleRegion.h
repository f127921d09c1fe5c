/**
 * @file    VisibleRegion.h
 * @brief   the part of a volume that clipping planes and cropping leave visible
 *
 * It is convex, so that a ray is inside along one interval, whose ends are exact. Its border
 * belongs to it.
 */

#ifndef VisibleRegion_h
#define VisibleRegion_h

#include "ShadowRay.h"

#include <vector>

class vtkImageData;
class vtkPlane;

namespace penumbra
{

class VisibleRegion
{
public:
  /// Nothing.
  VisibleRegion() = default;
  /// The volume's whole box.
  explicit VisibleRegion(const VolumeFrames& frames);

  /// Hides all outside of low and high, which are in voxel indices.
  void Crop(const Vector3& low, const Vector3& high);
  /// Hides the negative side of a plane of the world.
  void Clip(vtkPlane* plane);

  /// Shortens the ray to what of it is inside. False where that is nothing.
  bool Intersect(ShadowRay& ray) const;

private:
  void Cut(ShadowRay& ray, double distance, double slope) const;

  VolumeFrames Frames;
  double Reach = 0.0;
  Vector3 Low{};
  Vector3 High{};
  std::vector<std::array<double, 4>> Planes;
};

/// Cropping planes, given along each axis as origin + index * spacing, in voxel indices.
void ComputeCroppingInterval(
  vtkImageData* image, const double planes[6], Vector3& low, Vector3& high);

}

#endif
