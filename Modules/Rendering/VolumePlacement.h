/**
 * @file    VolumePlacement.h
 * @brief   where a volume is, in double precision
 *
 * Everything the shader marches in texture coordinates is composed here in double precision and
 * only the products become floats: volumes far from the origin, tiny or huge ones keep their
 * digits.
 *
 * Texture coordinates t of a voxel index i among n voxels: t = (i + 1/2) / n. The volume's box runs
 * from the first to the last voxel centre; along an axis with a single voxel it is one spacing
 * thick.
 */

#ifndef VolumePlacement_h
#define VolumePlacement_h

#include "PenumbraRenderingModule.h" // For export macro

#include <array>

class vtkImageData;
class vtkMatrix4x4;
class vtkPlane;

namespace penumbra
{

using Vector3 = std::array<double, 3>;
/// Row-major, acting on columns, like vtkMatrix4x4.
using Matrix3 = std::array<double, 9>;
using Matrix4 = std::array<double, 16>;

PENUMBRARENDERING_EXPORT Matrix4 Multiply(const Matrix4& a, const Matrix4& b);
/// False where there is no finite inverse.
PENUMBRARENDERING_EXPORT bool Invert(const Matrix4& matrix, Matrix4& inverse);
/// Product of a matrix's linear part and a vector.
PENUMBRARENDERING_EXPORT Vector3 MultiplyDirection(const Matrix4& matrix, const Vector3& direction);
/// Image of a point under an affine matrix.
PENUMBRARENDERING_EXPORT Vector3 MultiplyPoint(const Matrix4& matrix, const Vector3& point);
PENUMBRARENDERING_EXPORT double GetLength(const Vector3& vector);
/// The vector divided by its length; 0 stays 0.
PENUMBRARENDERING_EXPORT Vector3 Normalized(const Vector3& vector);

/// The box of a volume and the maps between its frames.
struct PENUMBRARENDERING_EXPORT VolumePlacement
{
  std::array<int, 3> Dimensions{};
  Matrix4 TextureToOwn{};   ///< to origin + direction * (index * spacing)
  Matrix4 TextureToWorld{}; ///< to the world, by the actor's matrix
  Matrix4 WorldToTexture{};
  Vector3 BoxLow{}; ///< the visible box in texture coordinates, cropped
  Vector3 BoxHigh{};
  Vector3 FullBoxLow{}; ///< the whole box
  Vector3 FullBoxHigh{};
  double SmallestSpacing = 1.0;
  double LargestSpacing = 1.0;
  double MeanSpacing = 1.0;

  /// Shrinks the visible box to what both it and the given one hold. False where that is nothing.
  bool CropBox(const Vector3& low, const Vector3& high);
  /// Length of the visible box's longest diagonal in the volume's own frame.
  double GetDiagonal() const;
  /// A clipping plane as (a, b, c, d) in texture coordinates, positive on the side that is kept.
  std::array<double, 4> GetPlane(vtkPlane* plane) const;
  /// Maps differences of the scalar per voxel to a vector along the gradient in the world.
  Matrix3 GetGradientToWorld() const;
  /// Maps differences of the scalar per voxel to the gradient in the own frame times the mean
  /// spacing.
  Matrix3 GetGradientToMagnitude() const;
};

/// Placement of an image under an actor's matrix. False where no inverse exists.
PENUMBRARENDERING_EXPORT bool ComputeVolumePlacement(
  vtkImageData* image, vtkMatrix4x4* actorMatrix, VolumePlacement& placement);

/// Texture coordinates of cropping planes, which are given along each axis as origin + index *
/// spacing. low and high are ordered per axis.
PENUMBRARENDERING_EXPORT void ComputeCroppingPlanes(
  vtkImageData* image, const double planes[6], Vector3& low, Vector3& high);

}

#endif
