#include "VisibleRegion.h"

#include "ReferenceScene.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace penumbra::reference
{

//------------------------------------------------------------------------------
VisibleRegion::VisibleRegion(const ReferenceScene& scene, const VolumeFrame& frame)
{
  this->AddBox(scene, frame);
  this->AddPlanes(scene, frame);
  if (scene.Mask)
  {
    this->AddMask(scene, frame);
  }
}

//------------------------------------------------------------------------------
void VisibleRegion::AddBox(const ReferenceScene& scene, const VolumeFrame& frame)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double low = frame.GetLowest()[axis];
    double high = frame.GetHighest()[axis];
    if (scene.Cropping)
    {
      low = std::max(low, frame.ToIndex((*scene.Cropping)[2 * axis], axis));
      high = std::min(high, frame.ToIndex((*scene.Cropping)[2 * axis + 1], axis));
    }
    vtkVector3d normal(0.0);
    normal[axis] = 1.0;
    this->HalfSpaces.push_back({ normal, -low });
    this->HalfSpaces.push_back({ -normal, high });
  }
}

//------------------------------------------------------------------------------
void VisibleRegion::AddPlanes(const ReferenceScene& scene, const VolumeFrame& frame)
{
  const vtkVector3d first = frame.ToWorld(vtkVector3d(0.0));
  for (const auto& plane : scene.ClippingPlanes)
  {
    const vtkVector3d normal = vtkVector3d(plane->GetNormal()).Normalized();
    const vtkVector3d origin(plane->GetOrigin());
    this->HalfSpaces.push_back({ frame.NormalToIndex(normal), normal.Dot(first - origin) });
  }
}

//------------------------------------------------------------------------------
void VisibleRegion::AddMask(const ReferenceScene& scene, const VolumeFrame& frame)
{
  this->Rows = frame.GetDimensions()[0];
  this->Slices = this->Rows * frame.GetDimensions()[1];
  vtkDataArray* scalars = scene.Mask->GetPointData()->GetScalars();
  this->Mask.resize(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < this->Mask.size(); ++i)
  {
    this->Mask[i] = scalars->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0;
  }
}

//------------------------------------------------------------------------------
bool VisibleRegion::Clip(VolumeRay& ray) const
{
  double begin = 0.0;
  double end = ray.Length;
  for (const HalfSpace& half : this->HalfSpaces)
  {
    const double atStart = half.Normal.Dot(ray.Start) + half.Offset;
    const double slope = half.Normal.Dot(ray.Direction);
    if (slope > 0.0)
    {
      begin = std::max(begin, -atStart / slope);
    }
    else if (slope < 0.0)
    {
      end = std::min(end, -atStart / slope);
    }
    else if (atStart < 0.0)
    {
      return false;
    }
  }
  if (!(begin < end))
  {
    return false;
  }
  ray.Cut(begin, end);
  return true;
}

}
