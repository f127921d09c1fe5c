#include "VisibleRegion.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Voxels. A ray along a border may lie this far outside by rounding and is inside nevertheless.
constexpr double Rounding = 1e-9;
}

//------------------------------------------------------------------------------
VisibleRegion::VisibleRegion(const VolumeFrames& frames)
  : Frames(frames)
  , Reach(frames.GetDiagonal())
  , Low(frames.BoxLow)
  , High(frames.BoxHigh)
{
}

//------------------------------------------------------------------------------
void VisibleRegion::Crop(const Vector3& low, const Vector3& high)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = std::max(this->Low[axis], low[axis]);
    this->High[axis] = std::min(this->High[axis], high[axis]);
  }
}

//------------------------------------------------------------------------------
void VisibleRegion::Clip(vtkPlane* plane)
{
  this->Planes.push_back(this->Frames.GetIndexPlane(plane));
}

//------------------------------------------------------------------------------
// Keeps where distance + slope * length >= 0.
void VisibleRegion::Cut(ShadowRay& ray, double distance, double slope) const
{
  if (std::abs(slope) * this->Reach < Rounding)
  {
    ray.End = distance < -Rounding ? ray.Begin : ray.End;
  }
  else if (slope > 0.0)
  {
    ray.Begin = std::max(ray.Begin, -distance / slope);
  }
  else
  {
    ray.End = std::min(ray.End, -distance / slope);
  }
}

//------------------------------------------------------------------------------
bool VisibleRegion::Intersect(ShadowRay& ray) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Cut(ray, ray.Origin[axis] - this->Low[axis], ray.Direction[axis]);
    this->Cut(ray, this->High[axis] - ray.Origin[axis], -ray.Direction[axis]);
  }
  for (const auto& plane : this->Planes)
  {
    double distance = plane[3];
    double slope = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      distance += plane[axis] * ray.Origin[axis];
      slope += plane[axis] * ray.Direction[axis];
    }
    this->Cut(ray, distance, slope);
  }
  return ray.Begin < ray.End;
}

//------------------------------------------------------------------------------
void ComputeCroppingInterval(
  vtkImageData* image, const double planes[6], Vector3& low, Vector3& high)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double index[2];
    for (int side = 0; side < 2; ++side)
    {
      index[side] =
        (planes[2 * axis + side] - image->GetOrigin()[axis]) / image->GetSpacing()[axis] -
        image->GetExtent()[2 * axis];
    }
    low[axis] = std::min(index[0], index[1]);
    high[axis] = std::max(index[0], index[1]);
  }
}

}
