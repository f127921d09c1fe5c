#include "ViewRays.h"

#include "vtkMath.h"

#include <algorithm>

namespace penumbra
{
namespace
{
Vector3 GetColumn(const Matrix4& matrix, int column)
{
  return { matrix[column], matrix[4 + column], matrix[8 + column] };
}

Vector3 Combine(const Vector3& a, double factor, const Vector3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
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

// All rays leave the eye. They are based on the plane through the middle of the volume, so that an
// eye far away costs no digits; where that plane is behind the eye, on the eye.
void ComputePerspectiveRays(const VolumePlacement& placement, const Matrix4& clipToTexture,
  const Vector3& eye, ViewRays& rays)
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
    toCenter[axis] = 0.5 * (placement.FullBoxLow[axis] + placement.FullBoxHigh[axis]) - eye[axis];
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
bool ComputeViewRays(
  const VolumePlacement& placement, const Matrix4& worldToClip, const Vector3& eye, ViewRays& rays)
{
  rays.TextureToClip = Multiply(worldToClip, placement.TextureToWorld);
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
      placement, clipToTexture, { z[0] / eyeW, z[1] / eyeW, z[2] / eyeW }, rays);
  }
  else
  {
    ComputeParallelRays(clipToTexture, MultiplyPoint(placement.WorldToTexture, eye), rays);
  }
  return true;
}

}
