/**
 * @file ViewedVolume.h
 * @brief Volumes before cameras near and far, inside and parallel, and the rays of their pixels.
 */
#ifndef ViewedVolume_h
#define ViewedVolume_h

#include "PlacedVolume.h"
#include "ViewRays.h"

#include <vtkCamera.h>
#include <vtkNew.h>

namespace penumbra
{
struct View
{
  std::string name;
  double distance; ///< of the eye from the volume's centre, in the volume's radii
  double viewAngle;
  bool parallel;
};

std::vector<View> MakeViews();

struct ViewedVolume
{
  PlacedVolume volume;
  VolumePlacement geometry;
  double radius; ///< of the volume in the world
  vtkNew<vtkCamera> camera;
  Matrix4 worldToClip;
  ViewRays rays;

  ViewedVolume(const PlacedVolume& placed, const View& view);

  Vector3 Eye() const;
  /// How far in front of the eye's plane a point in texture coordinates is, in the world.
  double Depth(const Vector3& texture) const;
  /// Normalized device coordinates of a point in texture coordinates, by VTK's maps alone.
  Vector3 Project(const Vector3& texture) const;
};

Vector3 PointOnRay(const Vector3& base, const Vector3& direction, double parameter);
}

#endif
