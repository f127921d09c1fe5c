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
Matrix4 Multiply(const Matrix4& a, const Matrix4& b)
{
  Matrix4 product;
  vtkMatrix4x4::Multiply4x4(a.data(), b.data(), product.data());
  return product;
}

bool Invert(const Matrix4& matrix, Matrix4& inverse)
{
  vtkMatrix4x4::Invert(matrix.data(), inverse.data());
  const bool finite =
    std::all_of(inverse.begin(), inverse.end(), [](double value) { return std::isfinite(value); });
  const double determinant = vtkMatrix4x4::Determinant(matrix.data());
  return finite && determinant != 0.0;
}

std::array<double, 4> MultiplyHomogeneous(const Matrix4& matrix, const std::array<double, 4>& point)
{
  std::array<double, 4> image;
  vtkMatrix4x4::MultiplyPoint(matrix.data(), point.data(), image.data());
  return image;
}

Vector3 GetColumn(const Matrix4& matrix, int column)
{
  return { matrix[column], matrix[4 + column], matrix[8 + column] };
}

Vector3 Combine(const Vector3& a, double factor, const Vector3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
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

// Inverse transpose of the linear map from voxels to a frame, given the map from texture coordinates.
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

// Solves [a b c] x = right for x.
Vector3 Solve(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& right)
{
  const double columns[3][3] = { { a[0], b[0], c[0] }, { a[1], b[1], c[1] }, { a[2], b[2], c[2] } };
  double inverse[3][3];
  vtkMath::Invert3x3(columns, inverse);
  Vector3 solution;
  vtkMath::Multiply3x3(inverse, right.data(), solution.data());
  return solution;
}

Matrix3 FromColumns(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return { a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2] };
}

// All rays leave the eye. They are based on the plane through the middle of the volume, so that an eye
// far away costs no digits; where that plane is behind the eye, on the eye.
void ComputePerspectiveRays(
  const VolumePlacement& geometry, const Matrix4& clipToTexture, const Vector3& eye, ViewRays& rays)
{
  Vector3 direction[3];
  const int columns[3] = { 0, 1, 3 };
  for (int i = 0; i < 3; ++i)
  {
    const double w = clipToTexture[12 + columns[i]];
    direction[i] = Combine(GetColumn(clipToTexture, columns[i]), -w, eye);
  }
  const double scale = 1.0 / GetLength(direction[2]);
  for (Vector3& column : direction)
  {
    column = { scale * column[0], scale * column[1], scale * column[2] };
  }
  Vector3 toCenter;
  for (int axis = 0; axis < 3; ++axis)
  {
    toCenter[axis] = 0.5 * (geometry.FullBoxLow[axis] + geometry.FullBoxHigh[axis]) - eye[axis];
  }
  const double parameter =
    std::max(Solve(direction[0], direction[1], direction[2], toCenter)[2], 0.0);
  rays.Direction = FromColumns(direction[0], direction[1], direction[2]);
  const Vector3 none = { 0.0, 0.0, 0.0 };
  rays.Base = FromColumns(Combine(none, parameter, direction[0]),
    Combine(none, parameter, direction[1]), Combine(eye, parameter, direction[2]));
  rays.EyeParameter = -parameter;
}

// All rays have one direction; those whose matter is behind the plane of the eye begin there.
void ComputeParallelRays(const Matrix4& clipToTexture, const Vector3& eye, ViewRays& rays)
{
  const Vector3 x = GetColumn(clipToTexture, 0);
  const Vector3 y = GetColumn(clipToTexture, 1);
  const Vector3 direction = Normalized(GetColumn(clipToTexture, 2));
  const Vector3 base = GetColumn(clipToTexture, 3);
  const Vector3 none = { 0.0, 0.0, 0.0 };
  rays.Base = FromColumns(x, y, base);
  rays.Direction = FromColumns(none, none, direction);
  rays.EyeParameter = Solve(x, y, direction, Combine(eye, -1.0, base))[2];
}
}

//------------------------------------------------------------------------------
Vector3 MultiplyDirection(const Matrix4& matrix, const Vector3& direction)
{
  const auto image =
    MultiplyHomogeneous(matrix, { direction[0], direction[1], direction[2], 0.0 });
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
  const double scale = 1.0 / std::max(std::hypot(result[0], result[1], result[2]),
                               std::numeric_limits<double>::min());
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
  vtkImageData* image, vtkMatrix4x4* actorMatrix, VolumePlacement& geometry)
{
  image->GetDimensions(geometry.Dimensions.data());
  const double* spacing = image->GetSpacing();
  geometry.SmallestSpacing = std::numeric_limits<double>::max();
  geometry.MeanSpacing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = geometry.Dimensions[axis];
    const double margin = count > 1 ? 0.5 / count : 0.0;
    geometry.FullBoxLow[axis] = margin;
    geometry.FullBoxHigh[axis] = 1.0 - margin;
    geometry.SmallestSpacing = std::min(geometry.SmallestSpacing, std::abs(spacing[axis]));
    geometry.MeanSpacing += std::abs(spacing[axis]) / 3.0;
  }
  geometry.BoxLow = geometry.FullBoxLow;
  geometry.BoxHigh = geometry.FullBoxHigh;

  Matrix4 ownToWorld;
  std::copy_n(actorMatrix->GetData(), 16, ownToWorld.begin());
  geometry.TextureToOwn = Multiply(GetIndexToOwn(image), GetTextureToIndex(image));
  geometry.TextureToWorld = Multiply(ownToWorld, geometry.TextureToOwn);
  return Invert(geometry.TextureToWorld, geometry.WorldToTexture);
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

//------------------------------------------------------------------------------
bool ComputeViewRays(
  const VolumePlacement& geometry, const Matrix4& worldToClip, const Vector3& eye, ViewRays& rays)
{
  rays.TextureToClip = Multiply(worldToClip, geometry.TextureToWorld);
  std::copy_n(rays.TextureToClip.begin() + 8, 4, rays.ClipDepth.begin());
  std::copy_n(rays.TextureToClip.begin() + 12, 4, rays.ClipW.begin());
  Matrix4 clipToTexture;
  if (!Invert(rays.TextureToClip, clipToTexture))
  {
    return false;
  }
  // Lines of sight meet where clip coordinates are (0, 0, z, 0): the eye, or infinitely far away.
  const double eyeW = clipToTexture[14];
  if (eyeW != 0.0)
  {
    const Vector3 z = GetColumn(clipToTexture, 2);
    ComputePerspectiveRays(
      geometry, clipToTexture, { z[0] / eyeW, z[1] / eyeW, z[2] / eyeW }, rays);
  }
  else
  {
    ComputeParallelRays(clipToTexture, MultiplyPoint(geometry.WorldToTexture, eye), rays);
  }
  return true;
}

}
