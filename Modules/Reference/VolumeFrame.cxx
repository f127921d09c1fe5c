#include "VolumeFrame.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkVectorOperators.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
Matrix3 Product(const Matrix3& a, const Matrix3& b)
{
  Matrix3 product;
  for (int row = 0; row < 3; ++row)
  {
    product[row] = MultiplyTransposed(b, a[row]);
  }
  return product;
}

/// By the cross products of the columns. False where there is none.
bool Invert(const Matrix3& m, Matrix3& inverse)
{
  const vtkVector3d x(m[0][0], m[1][0], m[2][0]);
  const vtkVector3d y(m[0][1], m[1][1], m[2][1]);
  const vtkVector3d z(m[0][2], m[1][2], m[2][2]);
  const double determinant = x.Dot(y.Cross(z));
  const double scale = 1.0 / determinant;
  inverse = { y.Cross(z) * scale, z.Cross(x) * scale, x.Cross(y) * scale };
  return std::all_of(inverse.begin(), inverse.end(),
    [](const vtkVector3d& row)
    { return std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]); });
}
}

//------------------------------------------------------------------------------
vtkVector3d Multiply(const Matrix3& matrix, const vtkVector3d& vector)
{
  return { matrix[0].Dot(vector), matrix[1].Dot(vector), matrix[2].Dot(vector) };
}

//------------------------------------------------------------------------------
vtkVector3d MultiplyTransposed(const Matrix3& matrix, const vtkVector3d& vector)
{
  return matrix[0] * vector[0] + matrix[1] * vector[1] + matrix[2] * vector[2];
}

//------------------------------------------------------------------------------
VolumeFrame::VolumeFrame(vtkImageData* volume, vtkMatrix4x4* actor)
  : Origin(volume->GetOrigin())
  , Spacing(volume->GetSpacing())
{
  const int* extent = volume->GetExtent();
  vtkVector3d actorOrigin(0.0);
  vtkVector3d ownOfFirst = this->Origin;
  vtkVector3d offset;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    this->First[axis] = extent[2 * axis];
    offset[axis] = this->First[axis] * this->Spacing[axis];
  }
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const double direction = volume->GetDirectionMatrix()->GetElement(row, column);
      this->OwnFromIndex[row][column] = direction * this->Spacing[column];
      ownOfFirst[row] += direction * offset[column];
      this->Actor[row][column] = actor ? actor->GetElement(row, column) : double(row == column);
    }
    actorOrigin[row] = actor ? actor->GetElement(row, 3) : 0.0;
  }
  this->WorldFromIndex = Product(this->Actor, this->OwnFromIndex);
  this->WorldOfFirst = Multiply(this->Actor, ownOfFirst) + actorOrigin;
  this->Invertible = Invert(this->OwnFromIndex, this->IndexFromOwn) &&
    Invert(this->WorldFromIndex, this->IndexFromWorld);
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::GetLowest() const
{
  vtkVector3d lowest;
  for (int axis = 0; axis < 3; ++axis)
  {
    lowest[axis] = this->Dimensions[axis] == 1 ? -0.5 : 0.0;
  }
  return lowest;
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::GetHighest() const
{
  vtkVector3d highest;
  for (int axis = 0; axis < 3; ++axis)
  {
    highest[axis] = this->Dimensions[axis] == 1 ? 0.5 : this->Dimensions[axis] - 1.0;
  }
  return highest;
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::ToWorld(const vtkVector3d& index) const
{
  return Multiply(this->WorldFromIndex, index) + this->WorldOfFirst;
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::ToIndex(const vtkVector3d& world) const
{
  return Multiply(this->IndexFromWorld, world - this->WorldOfFirst);
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::DirectionToIndex(const vtkVector3d& worldDirection) const
{
  return Multiply(this->IndexFromWorld, worldDirection);
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::OwnToWorld(const vtkVector3d& ownVector) const
{
  return Multiply(this->Actor, ownVector);
}

//------------------------------------------------------------------------------
double VolumeFrame::GetOwnLength(const vtkVector3d& indexVector) const
{
  return Multiply(this->OwnFromIndex, indexVector).Norm();
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::GradientToWorld(const vtkVector3d& perVoxel) const
{
  return MultiplyTransposed(this->IndexFromWorld, perVoxel);
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::GradientToOwn(const vtkVector3d& perVoxel) const
{
  return MultiplyTransposed(this->IndexFromOwn, perVoxel);
}

//------------------------------------------------------------------------------
vtkVector3d VolumeFrame::NormalToIndex(const vtkVector3d& worldNormal) const
{
  return MultiplyTransposed(this->WorldFromIndex, worldNormal);
}

//------------------------------------------------------------------------------
double VolumeFrame::ToIndex(double alongAxis, int axis) const
{
  return (alongAxis - this->Origin[axis]) / this->Spacing[axis] - this->First[axis];
}

//------------------------------------------------------------------------------
double VolumeFrame::GetSmallestSpacing() const
{
  return std::min({ this->Spacing[0], this->Spacing[1], this->Spacing[2] });
}

//------------------------------------------------------------------------------
double VolumeFrame::GetMeanSpacing() const
{
  return (this->Spacing[0] + this->Spacing[1] + this->Spacing[2]) / 3.0;
}

}
