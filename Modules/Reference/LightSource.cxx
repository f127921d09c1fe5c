#include "LightSource.h"

#include "ReferenceScene.h"
#include "TransferFunctions.h" // For LargestOpacity

#include "vtkMath.h"
#include "vtkVectorOperators.h"
#include "vtkVolumeLight.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
constexpr double NoCone = 90.0;

Rgb Scale(const double color[3], double factor)
{
  return { color[0] * factor, color[1] * factor, color[2] * factor };
}

vtkVector3d Transform(vtkMatrix4x4* matrix, const double point[3])
{
  const double homogeneous[4] = { point[0], point[1], point[2], 1.0 };
  double transformed[4] = { point[0], point[1], point[2], 1.0 };
  if (matrix)
  {
    matrix->MultiplyPoint(homogeneous, transformed);
  }
  return vtkVector3d(transformed) * (1.0 / transformed[3]);
}

vtkMatrix4x4* GetTransform(vtkLight* light, vtkCamera* camera)
{
  return light->LightTypeIsCameraLight() ? camera->GetCameraLightTransformMatrix()
                                         : light->GetTransformMatrix();
}

void Place(vtkLight* light, vtkCamera* camera, LightSource& source)
{
  if (light->LightTypeIsHeadlight())
  {
    source.Axis = vtkVector3d(camera->GetDirectionOfProjection()).Normalized();
    return;
  }
  vtkMatrix4x4* transform = GetTransform(light, camera);
  source.HasPosition = light->GetPositional() != 0;
  source.Position = Transform(transform, light->GetPosition());
  const vtkVector3d axis = Transform(transform, light->GetFocalPoint()) - source.Position;
  source.Axis = axis.Norm() > 0.0 ? axis.Normalized() : vtkVector3d(0.0);
}

void SetFalloff(vtkLight* light, LightSource& source)
{
  std::copy_n(light->GetAttenuationValues(), 3, source.Attenuation.begin());
  source.HasCone = source.HasPosition && light->GetConeAngle() < NoCone;
  source.CosineOfCone = std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
  source.Exponent = light->GetExponent();
}

void SetShadow(vtkVolumeLight* light, double smallestSpacing, LightSource& source)
{
  source.Shadow = static_cast<ShadowKind>(light->GetShadow());
  source.LargestDepth = -std::log1p(-std::min(light->GetOpacityThreshold(), LargestOpacity));
  source.Bias = light->GetShadowBias() < 0.0 ? smallestSpacing : light->GetShadowBias();
}

bool IsBlack(const Rgb& color)
{
  return color == Rgb{};
}
}

//------------------------------------------------------------------------------
double LightSource::GetAttenuation(double distance) const
{
  if (!this->HasPosition)
  {
    return 1.0;
  }
  const double denominator =
    this->Attenuation[0] + distance * (this->Attenuation[1] + distance * this->Attenuation[2]);
  return denominator > 0.0 ? std::min(1.0 / denominator, 1.0) : 1.0;
}

//------------------------------------------------------------------------------
double LightSource::GetSpot(const vtkVector3d& direction) const
{
  if (!this->HasCone)
  {
    return 1.0;
  }
  const double cosine = this->Axis.Dot(direction);
  return cosine > 0.0 && cosine >= this->CosineOfCone ? std::pow(cosine, this->Exponent) : 0.0;
}

//------------------------------------------------------------------------------
std::vector<LightSource> MakeLightSources(const ReferenceScene& scene, double smallestSpacing)
{
  std::vector<LightSource> sources;
  for (const auto& light : scene.Lights)
  {
    LightSource source;
    source.Diffuse = Scale(light->GetDiffuseColor(), light->GetIntensity());
    source.Specular = Scale(light->GetSpecularColor(), light->GetIntensity());
    if (!light->GetSwitch() || (IsBlack(source.Diffuse) && IsBlack(source.Specular)))
    {
      continue;
    }
    Place(light, scene.Camera, source);
    SetFalloff(light, source);
    if (auto* volumeLight = vtkVolumeLight::SafeDownCast(light))
    {
      SetShadow(volumeLight, smallestSpacing, source);
    }
    sources.push_back(source);
  }
  return sources;
}

//------------------------------------------------------------------------------
Rgb GetAmbientLight(const ReferenceScene& scene)
{
  Rgb sum{};
  bool isOn = false;
  bool allPlainAndBlack = true;
  for (const auto& light : scene.Lights)
  {
    if (light->GetSwitch())
    {
      isOn = true;
      const Rgb color = Scale(light->GetAmbientColor(), 1.0);
      allPlainAndBlack = allPlainAndBlack && IsBlack(color) && !vtkVolumeLight::SafeDownCast(light);
      for (int channel = 0; channel < 3; ++channel)
      {
        sum[channel] += color[channel] * light->GetIntensity();
      }
    }
  }
  return isOn && allPlainAndBlack ? Rgb{ 1.0, 1.0, 1.0 } : sum;
}

}
