#include "PlacedVolume.h"

#include <stdexcept>

namespace penumbra
{
//------------------------------------------------------------------------------
VolumePlacement PlacedVolume::Geometry() const
{
  VolumePlacement geometry;
  if (!ComputeVolumePlacement(this->image, this->actorMatrix, geometry))
  {
    throw std::runtime_error(this->name + " has no inverse");
  }
  return geometry;
}

//------------------------------------------------------------------------------
Vector3 PlacedVolume::ToOwn(const Vector3& texture) const
{
  const int* dimensions = this->image->GetDimensions();
  const int* extent = this->image->GetExtent();
  Vector3 index;
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = texture[axis] * dimensions[axis] - 0.5 + extent[2 * axis];
  }
  Vector3 own;
  this->image->TransformContinuousIndexToPhysicalPoint(index.data(), own.data());
  return own;
}

//------------------------------------------------------------------------------
Vector3 PlacedVolume::ToWorld(const Vector3& texture) const
{
  const Vector3 own = this->ToOwn(texture);
  const double point[4] = { own[0], own[1], own[2], 1.0 };
  double world[4];
  this->actorMatrix->MultiplyPoint(point, world);
  return { world[0], world[1], world[2] };
}

//------------------------------------------------------------------------------
Vector3 RandomPointInBox(const VolumePlacement& geometry, std::mt19937& generator)
{
  Vector3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::uniform_real_distribution<double> even(
      geometry.FullBoxLow[axis], geometry.FullBoxHigh[axis]);
    point[axis] = even(generator);
  }
  return point;
}

//------------------------------------------------------------------------------
double GetDistance(const Vector3& a, const Vector3& b)
{
  return GetLength({ a[0] - b[0], a[1] - b[1], a[2] - b[2] });
}

//------------------------------------------------------------------------------
double GetDotProduct(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}
