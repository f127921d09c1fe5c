#include "VolumeFrames.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
Vector3 Multiply(const Matrix3& matrix, const Vector3& vector)
{
  Vector3 result;
  vtkMatrix3x3::MultiplyPoint(matrix.data(), vector.data(), result.data());
  return result;
}

//------------------------------------------------------------------------------
bool Invert(const Matrix3& matrix, Matrix3& inverse)
{
  double rows[3][3];
  std::copy(matrix.begin(), matrix.end(), &rows[0][0]);
  double inverseRows[3][3];
  vtkMath::Invert3x3(rows, inverseRows);
  std::copy_n(&inverseRows[0][0], 9, inverse.begin());
  // Pivoting finds an inverse of a matrix of any scale, and something wild of a singular one.
  constexpr double tolerance = 1e-6;
  Matrix3 product;
  vtkMatrix3x3::Multiply3x3(matrix.data(), inverse.data(), product.data());
  for (int element = 0; element < 9; ++element)
  {
    const double identity = element % 4 == 0 ? 1.0 : 0.0;
    if (!(std::abs(product[element] - identity) < tolerance))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
Matrix3 GetIndexToOwn(vtkImageData* image)
{
  Matrix3 matrix;
  for (int element = 0; element < 9; ++element)
  {
    matrix[element] =
      image->GetDirectionMatrix()->GetData()[element] * image->GetSpacing()[element % 3];
  }
  return matrix;
}

//------------------------------------------------------------------------------
Matrix3 GetLinearPart(vtkMatrix4x4* matrix)
{
  Matrix3 linear;
  for (int element = 0; element < 9; ++element)
  {
    linear[element] = matrix ? matrix->GetElement(element / 3, element % 3) : element % 4 == 0;
  }
  return linear;
}

//------------------------------------------------------------------------------
Vector3 GetFirstVoxel(vtkImageData* image, vtkMatrix4x4* actorMatrix, const Matrix3& indexToOwn)
{
  const int* extent = image->GetExtent();
  const Vector3 index = { static_cast<double>(extent[0]), static_cast<double>(extent[2]),
    static_cast<double>(extent[4]) };
  Vector3 own = Multiply(indexToOwn, index);
  for (int axis = 0; axis < 3; ++axis)
  {
    own[axis] += image->GetOrigin()[axis];
  }
  Vector3 world = Multiply(GetLinearPart(actorMatrix), own);
  for (int axis = 0; axis < 3 && actorMatrix; ++axis)
  {
    world[axis] += actorMatrix->GetElement(axis, 3);
  }
  return world;
}
}

//------------------------------------------------------------------------------
Vector3 VolumeFrames::GetIndexPosition(const Vector3& world) const
{
  return Multiply(this->WorldToIndex,
    { world[0] - this->FirstVoxel[0], world[1] - this->FirstVoxel[1],
      world[2] - this->FirstVoxel[2] });
}

//------------------------------------------------------------------------------
double VolumeFrames::GetOwnLength(const Vector3& index) const
{
  const Vector3 own = Multiply(this->IndexToOwn, index);
  return std::hypot(own[0], own[1], own[2]);
}

//------------------------------------------------------------------------------
double VolumeFrames::GetDiagonal() const
{
  double longest = 0.0;
  for (int diagonal = 0; diagonal < 4; ++diagonal)
  {
    Vector3 difference;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool reversed = axis < 2 && ((diagonal >> axis) & 1) != 0;
      const double length = this->BoxHigh[axis] - this->BoxLow[axis];
      difference[axis] = reversed ? -length : length;
    }
    longest = std::max(longest, this->GetOwnLength(difference));
  }
  return longest;
}

//------------------------------------------------------------------------------
Matrix3 VolumeFrames::GetGradientToOwn() const
{
  Matrix3 inverse;
  Invert(this->IndexToOwn, inverse);
  vtkMatrix3x3::Transpose(inverse.data(), inverse.data());
  return inverse;
}

//------------------------------------------------------------------------------
std::array<double, 4> VolumeFrames::GetIndexPlane(vtkPlane* plane) const
{
  const double* normal = plane->GetNormal();
  std::array<double, 4> result{};
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis] += normal[row] * this->IndexToWorld[3 * row + axis];
    }
    result[3] += normal[row] * (this->FirstVoxel[row] - plane->GetOrigin()[row]);
  }
  const double scale = std::hypot(result[0], result[1], result[2]);
  for (double& coefficient : result)
  {
    coefficient = scale > 0.0 ? coefficient / scale : 0.0;
  }
  return result;
}

//------------------------------------------------------------------------------
bool ComputeVolumeFrames(vtkImageData* image, vtkMatrix4x4* actorMatrix, VolumeFrames& frames)
{
  image->GetDimensions(frames.Dimensions.data());
  frames.IndexToOwn = GetIndexToOwn(image);
  vtkMatrix3x3::Multiply3x3(
    GetLinearPart(actorMatrix).data(), frames.IndexToOwn.data(), frames.IndexToWorld.data());
  frames.FirstVoxel = GetFirstVoxel(image, actorMatrix, frames.IndexToOwn);
  const double* spacing = image->GetSpacing();
  frames.SmallestSpacing = std::abs(spacing[0]);
  frames.MeanSpacing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = frames.Dimensions[axis] - 1;
    frames.BoxLow[axis] = last > 0 ? 0.0 : -0.5;
    frames.BoxHigh[axis] = last > 0 ? last : 0.5;
    frames.SmallestSpacing = std::min(frames.SmallestSpacing, std::abs(spacing[axis]));
    frames.MeanSpacing += std::abs(spacing[axis]) / 3.0;
  }
  Matrix3 ownInverse;
  return Invert(frames.IndexToOwn, ownInverse) && Invert(frames.IndexToWorld, frames.WorldToIndex);
}

}
