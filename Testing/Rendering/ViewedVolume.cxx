#include "ViewedVolume.h"

#include <algorithm>
#include <stdexcept>

namespace penumbra
{

//------------------------------------------------------------------------------
std::vector<View> MakeViews()
{
  return {
    { "near", 3.0, 40.0, false },
    { "far and wide", 1e6, 30.0, false },
    { "far through a telescope", 1e6, 1e-4, false },
    { "inside", 0.1, 60.0, false },
    { "parallel", 3.0, 0.0, true },
    { "parallel and far", 1e6, 0.0, true },
    { "parallel and inside", 0.1, 0.0, true },
  };
}

//------------------------------------------------------------------------------
ViewedVolume::ViewedVolume(const PlacedVolume& placed, const View& view)
  : volume(placed)
  , geometry(placed.Geometry())
{
  constexpr double aspect = 1.25;
  const Vector3 center = placed.ToWorld({ 0.5, 0.5, 0.5 });
  this->radius = GetDistance(placed.ToWorld(this->geometry.FullBoxHigh), center);
  const double distance = view.distance * this->radius;
  this->camera->SetFocalPoint(center.data());
  this->camera->SetPosition(
    center[0] + 0.48 * distance, center[1] - 0.64 * distance, center[2] + 0.6 * distance);
  this->camera->SetViewUp(0.1, 0.2, 1.0);
  this->camera->SetViewAngle(view.viewAngle);
  this->camera->SetParallelProjection(view.parallel);
  this->camera->SetParallelScale(1.2 * this->radius);
  this->camera->SetClippingRange(
    std::max(distance - 4.0 * this->radius, 1e-3 * this->radius), distance + 4.0 * this->radius);
  const double* matrix =
    this->camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)->GetData();
  std::copy_n(matrix, 16, this->worldToClip.begin());
  if (!ComputeViewRays(this->geometry, this->worldToClip, this->Eye(), this->rays))
  {
    throw std::runtime_error(placed.name + " has no rays");
  }
}

//------------------------------------------------------------------------------
Vector3 ViewedVolume::Eye() const
{
  Vector3 eye;
  this->camera->GetPosition(eye.data());
  return eye;
}

//------------------------------------------------------------------------------
double ViewedVolume::Depth(const Vector3& texture) const
{
  const Vector3 world = this->volume.ToWorld(texture);
  const Vector3 eye = this->Eye();
  Vector3 direction;
  this->camera->GetDirectionOfProjection(direction.data());
  return GetDotProduct({ world[0] - eye[0], world[1] - eye[1], world[2] - eye[2] }, direction);
}

//------------------------------------------------------------------------------
Vector3 ViewedVolume::Project(const Vector3& texture) const
{
  return MultiplyPoint(this->worldToClip, this->volume.ToWorld(texture));
}

//------------------------------------------------------------------------------
Vector3 PointOnRay(const Vector3& base, const Vector3& direction, double parameter)
{
  return { base[0] + parameter * direction[0], base[1] + parameter * direction[1],
    base[2] + parameter * direction[2] };
}

}
