#include "ShadowedLights.h"

#include "vtkLightCollection.h"
#include "vtkVolumeLight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
Vector3 Scaled(const Vector3& vector, double factor)
{
  return { vector[0] * factor, vector[1] * factor, vector[2] * factor };
}

//------------------------------------------------------------------------------
Vector3 Subtract(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

//------------------------------------------------------------------------------
Vector3 GetPosition(vtkLight* light)
{
  Vector3 position;
  light->GetTransformedPosition(position.data());
  return position;
}

//------------------------------------------------------------------------------
Vector3 GetTravel(vtkLight* light, const Vector3& cameraDirection)
{
  if (light->LightTypeIsHeadlight())
  {
    return cameraDirection;
  }
  Vector3 focalPoint;
  light->GetTransformedFocalPoint(focalPoint.data());
  return Subtract(focalPoint, GetPosition(light));
}

//------------------------------------------------------------------------------
// Differences of indices towards the light, per length of the own frame. 0 where it has no
// direction.
Vector3 GetIndexDirection(const VolumeFrames& frames, const Vector3& travel)
{
  const double length = std::hypot(travel[0], travel[1], travel[2]);
  const Vector3 towards = Scaled(travel, length > 0.0 ? -1.0 / length : 0.0);
  VolumeFrames atLight = frames;
  atLight.FirstVoxel = { 0.0, 0.0, 0.0 };
  const Vector3 direction = atLight.GetIndexPosition(towards);
  const double ownLength = frames.GetOwnLength(direction);
  return Scaled(direction, ownLength > 0.0 ? 1.0 / ownLength : 0.0);
}

//------------------------------------------------------------------------------
double GetLargestDepth(vtkVolumeLight* light, double negligibleVisibility)
{
  constexpr double largestOpacity = 1.0 - 1.0 / 16777216.0; // 1 - 2^-24
  return light->GetShadow() == vtkVolumeLight::Hard
    ? -std::log1p(-std::min(light->GetOpacityThreshold(), largestOpacity))
    : -std::log(negligibleVisibility);
}

//------------------------------------------------------------------------------
template <typename Visitor>
void VisitShadowedLights(vtkLightCollection* lights, Visitor visit)
{
  int index = 0;
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (light->GetSwitch() && GetShadowKind(light) != ShadowKind::None)
    {
      visit(vtkVolumeLight::SafeDownCast(light), index);
    }
    ++index;
  }
}
}

//------------------------------------------------------------------------------
std::string ShadowedLight::GetName() const
{
  static const char* const kinds[] = { "Directional", "Point", "Spot" };
  const bool headlight = this->Headlight && this->Kind == LightKind::Directional;
  return "Visibility" + std::to_string(this->Index) +
    (headlight ? "Headlight" : kinds[static_cast<int>(this->Kind)]);
}

//------------------------------------------------------------------------------
ShadowRay ShadowedLight::MakeRay(const VolumeFrames& frames, const Vector3& point) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (this->Kind == LightKind::Directional)
  {
    const bool towardsLight = this->DirectionOrPosition != Vector3{};
    return { point, this->DirectionOrPosition, this->Bias, towardsLight ? infinity : 0.0 };
  }
  const Vector3 towards = Subtract(this->DirectionOrPosition, point);
  const double distance = frames.GetOwnLength(towards);
  return { point, Scaled(towards, distance > 0.0 ? 1.0 / distance : 0.0), this->Bias, distance };
}

//------------------------------------------------------------------------------
double ShadowedLight::GetVisibility(double opticalDepth) const
{
  if (opticalDepth > this->LargestDepth)
  {
    return 0.0;
  }
  return this->Hard ? 1.0 : std::exp(-opticalDepth);
}

//------------------------------------------------------------------------------
std::vector<vtkVolumeLight*> FindShadowedLights(vtkLightCollection* lights)
{
  std::vector<vtkVolumeLight*> found;
  VisitShadowedLights(lights, [&](vtkVolumeLight* light, int) { found.push_back(light); });
  return found;
}

//------------------------------------------------------------------------------
std::vector<ShadowedLight> MakeShadowedLights(vtkLightCollection* lights,
  const VolumeFrames& frames, const Vector3& cameraDirection, double negligibleVisibility)
{
  std::vector<ShadowedLight> shadowed;
  VisitShadowedLights(lights,
    [&](vtkVolumeLight* light, int index)
    {
      ShadowedLight result;
      result.Index = index;
      result.Kind = GetLightKind(light);
      result.Headlight = light->LightTypeIsHeadlight() != 0;
      result.Hard = GetShadowKind(light) == ShadowKind::Hard;
      const double bias = light->GetShadowBias();
      result.Bias = bias >= 0.0 ? bias : frames.SmallestSpacing;
      result.LargestDepth = GetLargestDepth(light, negligibleVisibility);
      result.DirectionOrPosition = result.Kind == LightKind::Directional
        ? GetIndexDirection(frames, GetTravel(light, cameraDirection))
        : frames.GetIndexPosition(GetPosition(light));
      shadowed.push_back(result);
    });
  return shadowed;
}

}
