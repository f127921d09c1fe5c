#include "VolumePlacement.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
std::array<double, 4> MultiplyHomogeneous(const Matrix4& matrix, const std::array<double, 4>& point)
{
  std::array<double, 4> image;
  vtkMatrix4x4::MultiplyPoint(matrix.data(), point.data(), image.data());
  return image;
}

// Maps texture coordinates to voxel indices of the whole extent.
Matrix4 GetTextureToIndex(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  Matrix4 matrix{};
  for (int axis = 0; axis < 3; ++axis)
  {
    matrix[5 * axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    matrix[4 * axis + 3] = extent[2 * axis] - 0.5;
  }
  matrix[15] = 1.0;
  return matrix;
}

Matrix4 GetIndexToOwn(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  const double* direction = image->GetDirectionMatrix()->GetData();
  Matrix4 matrix{};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = direction[3 * row + column] * spacing[column];
    }
    matrix[4 * row + 3] = origin[row];
  }
  matrix[15] = 1.0;
  return matrix;
}

// Inverse transpose of the linear map from voxels to a frame, given the map from texture
// coordinates.
Matrix3 GetCovariantMap(const Matrix4& fromTexture, const std::array<int, 3>& dimensions)
{
  double map[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      map[row][column] = fromTexture[4 * row + column] / dimensions[column];
    }
  }
  double inverse[3][3];
  vtkMath::Invert3x3(map, inverse);
  Matrix3 result;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      result[3 * row + column] = inverse[column][row];
    }
  }
  return result;
}

Matrix3 Scaled(Matrix3 matrix, double factor)
{
  for (double& element : matrix)
  {
    element *= factor;
  }
  return matrix;
}

double GetLargestMagnitude(const Matrix3& matrix)
{
  double largest = 0.0;
  for (double element : matrix)
  {
    largest = std::max(largest, std::abs(element));
  }
  return largest;
}

}

//------------------------------------------------------------------------------
Matrix4 Multiply(const Matrix4& a, const Matrix4& b)
{
  Matrix4 product;
  vtkMatrix4x4::Multiply4x4(a.data(), b.data(), product.data());
  return product;
}

//------------------------------------------------------------------------------
bool Invert(const Matrix4& matrix, Matrix4& inverse)
{
  vtkMatrix4x4::Invert(matrix.data(), inverse.data());
  const bool finite =
    std::all_of(inverse.begin(), inverse.end(), [](double value) { return std::isfinite(value); });
  const double determinant = vtkMatrix4x4::Determinant(matrix.data());
  return finite && determinant != 0.0;
}

//------------------------------------------------------------------------------
Vector3 MultiplyDirection(const Matrix4& matrix, const Vector3& direction)
{
  const auto image = MultiplyHomogeneous(matrix, { direction[0], direction[1], direction[2], 0.0 });
  return { image[0], image[1], image[2] };
}

//------------------------------------------------------------------------------
Vector3 MultiplyPoint(const Matrix4& matrix, const Vector3& point)
{
  const auto image = MultiplyHomogeneous(matrix, { point[0], point[1], point[2], 1.0 });
  return { image[0] / image[3], image[1] / image[3], image[2] / image[3] };
}

//------------------------------------------------------------------------------
double GetLength(const Vector3& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

//------------------------------------------------------------------------------
Vector3 Normalized(const Vector3& vector)
{
  const double length = GetLength(vector);
  const double factor = length > 0.0 ? 1.0 / length : 0.0;
  return { vector[0] * factor, vector[1] * factor, vector[2] * factor };
}

//------------------------------------------------------------------------------
bool VolumePlacement::CropBox(const Vector3& low, const Vector3& high)
{
  bool anything = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->BoxLow[axis] = std::max(this->BoxLow[axis], low[axis]);
    this->BoxHigh[axis] = std::min(this->BoxHigh[axis], high[axis]);
    anything = anything && this->BoxLow[axis] < this->BoxHigh[axis];
  }
  return anything;
}

//------------------------------------------------------------------------------
double VolumePlacement::GetDiagonal() const
{
  double longest = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    Vector3 diagonal;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = axis < 2 && (corner >> axis) & 1 ? -1.0 : 1.0;
      diagonal[axis] = sign * (this->BoxHigh[axis] - this->BoxLow[axis]);
    }
    longest = std::max(longest, GetLength(MultiplyDirection(this->TextureToOwn, diagonal)));
  }
  return longest;
}

//------------------------------------------------------------------------------
std::array<double, 4> VolumePlacement::GetPlane(vtkPlane* plane) const
{
  double normal[3];
  double origin[3];
  plane->GetNormal(normal);
  plane->GetOrigin(origin);
  const Vector3 originInTexture =
    MultiplyPoint(this->WorldToTexture, { origin[0], origin[1], origin[2] });
  std::array<double, 4> result{};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      result[axis] += normal[row] * this->TextureToWorld[4 * row + axis];
    }
  }
  const double scale =
    1.0 / std::max(std::hypot(result[0], result[1], result[2]), std::numeric_limits<double>::min());
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] *= scale;
    result[3] -= result[axis] * originInTexture[axis];
  }
  return result;
}

//------------------------------------------------------------------------------
Matrix3 VolumePlacement::GetGradientToWorld() const
{
  const Matrix3 map = GetCovariantMap(this->TextureToWorld, this->Dimensions);
  return Scaled(map, 1.0 / GetLargestMagnitude(map));
}

//------------------------------------------------------------------------------
Matrix3 VolumePlacement::GetGradientToMagnitude() const
{
  return Scaled(GetCovariantMap(this->TextureToOwn, this->Dimensions), this->MeanSpacing);
}

//------------------------------------------------------------------------------
bool ComputeVolumePlacement(
  vtkImageData* image, vtkMatrix4x4* actorMatrix, VolumePlacement& placement)
{
  image->GetDimensions(placement.Dimensions.data());
  const double* spacing = image->GetSpacing();
  placement.SmallestSpacing = std::numeric_limits<double>::max();
  placement.LargestSpacing = 0.0;
  placement.MeanSpacing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = placement.Dimensions[axis];
    const double margin = count > 1 ? 0.5 / count : 0.0;
    placement.FullBoxLow[axis] = margin;
    placement.FullBoxHigh[axis] = 1.0 - margin;
    placement.SmallestSpacing = std::min(placement.SmallestSpacing, std::abs(spacing[axis]));
    placement.LargestSpacing = std::max(placement.LargestSpacing, std::abs(spacing[axis]));
    placement.MeanSpacing += std::abs(spacing[axis]) / 3.0;
  }
  placement.BoxLow = placement.FullBoxLow;
  placement.BoxHigh = placement.FullBoxHigh;

  Matrix4 ownToWorld;
  std::copy_n(actorMatrix->GetData(), 16, ownToWorld.begin());
  placement.TextureToOwn = Multiply(GetIndexToOwn(image), GetTextureToIndex(image));
  placement.TextureToWorld = Multiply(ownToWorld, placement.TextureToOwn);
  return Invert(placement.TextureToWorld, placement.WorldToTexture);
}

//------------------------------------------------------------------------------
void ComputeCroppingPlanes(vtkImageData* image, const double planes[6], Vector3& low, Vector3& high)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const Matrix4 textureToIndex = GetTextureToIndex(image);
  for (int axis = 0; axis < 3; ++axis)
  {
    double coordinate[2];
    for (int side = 0; side < 2; ++side)
    {
      const double index = (planes[2 * axis + side] - origin[axis]) / spacing[axis];
      coordinate[side] = (index - textureToIndex[4 * axis + 3]) / textureToIndex[5 * axis];
    }
    low[axis] = std::min(coordinate[0], coordinate[1]);
    high[axis] = std::max(coordinate[0], coordinate[1]);
  }
}

}
