#include "SceneCamera.h"

#include "InputError.h"
#include "JsonObject.h"
#include "VolumeBox.h"

#include <nlohmann/json.hpp>

#include <vtkCamera.h>
#include <vtkMath.h>

#include <algorithm>
#include <limits>

namespace penumbra
{
namespace
{
// Below this sine of the angle between them, two directions count as parallel.
constexpr double SmallestSine = 1e-6;
// Chosen directions keep this much more apart.
constexpr double ComfortableSine = 0.05;

constexpr Vector3 DefaultViewUps[] = { { 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 } };
// From the volume to the eye. In a patient's axes (DICOM's) -y is the front.
constexpr Vector3 DefaultDirectionsToEye[] = { { -0.5, -1.0, 0.4 }, { -0.5, 0.4, 1.0 } };

// Part of the picture that is left free around the volume.
constexpr double Margin = 1.04;
// Of the far plane's distance, where the volume reaches to the eye or behind it.
constexpr double NearestClippingPlane = 1e-4;

double SineBetween(const Vector3& a, const Vector3& b)
{
  return Length(Cross(UnitVector(a), UnitVector(b)));
}

template <std::size_t Size>
const Vector3& FirstAcross(const Vector3 (&candidates)[Size], const Vector3& direction)
{
  const auto isAcross = [&direction](const Vector3& candidate)
  { return SineBetween(candidate, direction) > ComfortableSine; };
  return *std::find_if(candidates, candidates + Size - 1, isAcross);
}

// Distance from `focalPoint` at which all of the box is within the view angle.
double FittingDistance(const CameraDescription& camera, const Vector3& focalPoint,
  const Vector3& toEye, const VolumeBox& box, double aspect)
{
  const Vector3 right = UnitVector(Cross(*camera.ViewUp, toEye));
  const Vector3 up = Cross(toEye, right);
  const double slope = std::tan(vtkMath::RadiansFromDegrees(camera.ViewAngle) / 2.0);
  double distance = 0.0;
  for (const Vector3& corner : box.GetCorners())
  {
    const Vector3 offset = Difference(corner, focalPoint);
    const double sideways =
      std::max(std::abs(Dot(offset, right)) / aspect, std::abs(Dot(offset, up)));
    distance = std::max(distance, Dot(offset, toEye) + Margin * sideways / slope);
  }
  return distance;
}

std::string InWords(const Vector3& vector)
{
  return ValueInWords(nlohmann::json(vector));
}
}

//------------------------------------------------------------------------------
void CheckView(const CameraDescription& camera)
{
  if (camera.ViewUp && Length(*camera.ViewUp) == 0.0)
  {
    throw InputError(
      "camera.viewUp is " + InWords(*camera.ViewUp) + "; accepted: a vector other than zero");
  }
  if (!camera.Position || !camera.FocalPoint)
  {
    return;
  }
  const Vector3 direction = Difference(*camera.FocalPoint, *camera.Position);
  const double farthest = std::max(Length(*camera.Position), Length(*camera.FocalPoint));
  // As far apart as rounding leaves their difference a direction.
  if (!(Length(direction) > 16.0 * std::numeric_limits<double>::epsilon() * farthest))
  {
    throw InputError("camera.position is " + InWords(*camera.Position) +
      ", as is camera.focalPoint; accepted: two different points");
  }
  if (camera.ViewUp && SineBetween(direction, *camera.ViewUp) < SmallestSine)
  {
    throw InputError("camera.viewUp is " + InWords(*camera.ViewUp) +
      ", along the view from camera.position to camera.focalPoint; accepted: a vector across it");
  }
}

//------------------------------------------------------------------------------
void ResolveCamera(CameraDescription& camera, const VolumeBox& box, double aspect)
{
  if (!camera.FocalPoint)
  {
    camera.FocalPoint = box.GetCenter();
  }
  CheckView(camera);
  if (!camera.Position)
  {
    const Vector3 toEye =
      UnitVector(camera.ViewUp ? FirstAcross(DefaultDirectionsToEye, *camera.ViewUp)
                               : DefaultDirectionsToEye[0]);
    camera.ViewUp = camera.ViewUp.value_or(DefaultViewUps[0]);
    const double distance = FittingDistance(camera, *camera.FocalPoint, toEye, box, aspect);
    camera.Position = Sum(*camera.FocalPoint, Scaled(toEye, distance));
  }
  if (!camera.ViewUp)
  {
    camera.ViewUp = FirstAcross(DefaultViewUps, Difference(*camera.Position, *camera.FocalPoint));
  }
  CheckView(camera);
}

//------------------------------------------------------------------------------
void ApplyCamera(const CameraDescription& description, vtkCamera* camera)
{
  camera->SetFocalPoint(description.FocalPoint->data());
  camera->SetPosition(description.Position->data());
  camera->SetViewUp(description.ViewUp->data());
  camera->SetViewAngle(description.ViewAngle);
  camera->SetParallelProjection(description.ParallelScale.has_value());
  if (description.ParallelScale)
  {
    camera->SetParallelScale(*description.ParallelScale);
  }
}

//------------------------------------------------------------------------------
void FitClippingRange(vtkCamera* camera, const VolumeBox& box)
{
  Vector3 eye;
  Vector3 direction;
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(direction.data());
  double nearest = std::numeric_limits<double>::max();
  double farthest = std::numeric_limits<double>::lowest();
  for (const Vector3& corner : box.GetCorners())
  {
    const double depth = Dot(Difference(corner, eye), direction);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double slack = 0.1 * (farthest - nearest);
  const double farPlane = farthest > 0.0 ? farthest + slack : camera->GetDistance();
  const double nearPlane = std::max(nearest - slack, NearestClippingPlane * farPlane);
  camera->SetClippingRange(nearPlane, farPlane);
}

//------------------------------------------------------------------------------
CameraAxes::CameraAxes(vtkCamera* camera)
{
  Vector3 direction;
  Vector3 up;
  camera->GetDirectionOfProjection(direction.data());
  camera->GetViewUp(up.data());
  this->Backward = Scaled(direction, -1.0);
  this->Right = UnitVector(Cross(direction, up));
  this->Up = Cross(this->Backward, this->Right);
}

//------------------------------------------------------------------------------
Vector3 CameraAxes::ToWorld(const Vector3& v) const
{
  return Sum(Sum(Scaled(this->Right, v[0]), Scaled(this->Up, v[1])), Scaled(this->Backward, v[2]));
}

}
