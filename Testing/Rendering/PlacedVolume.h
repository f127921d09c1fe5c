/**
 * @file PlacedVolume.h
 * @brief Volumes of every geometry that VTK can place in the world.
 */
#ifndef PlacedVolume_h
#define PlacedVolume_h

#include "VolumePlacement.h"

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <random>
#include <string>
#include <vector>

namespace penumbra
{
struct PlacedVolume
{
  std::string name;
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkMatrix4x4> actorMatrix;

  VolumePlacement Geometry() const;
  /// Where texture coordinates are, by VTK's own maps.
  Vector3 ToOwn(const Vector3& texture) const;
  Vector3 ToWorld(const Vector3& texture) const;
};

/// Rotated, mirrored, anisotropic, off the origin, of an extent that does not begin at 0, single
/// slices, tiny and huge; under actors that rotate, mirror, scale and shear.
std::vector<PlacedVolume> MakePlacedVolumes();

/// Even within the volume's box.
Vector3 RandomPointInBox(const VolumePlacement& geometry, std::mt19937& generator);

double GetDistance(const Vector3& a, const Vector3& b);
double GetDotProduct(const Vector3& a, const Vector3& b);
}

#endif
