#include "LightingRequirements.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkVolumeLight.h"
#include "vtkVolumeMaterial.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <tuple>

namespace penumbra
{
namespace
{
// A cone of half a turn or more is no cone (VTK's convention).
constexpr double NoConeAngle = 90.0;

bool IsBlack(const double color[3])
{
  return color[0] <= 0.0 && color[1] <= 0.0 && color[2] <= 0.0;
}

template <typename Visitor>
void VisitLightsThatAreOn(vtkLightCollection* lights, Visitor visit)
{
  if (!lights)
  {
    return;
  }
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (light->GetSwitch())
    {
      visit(light);
    }
  }
}

bool HasAttenuation(vtkLight* light)
{
  const double* values = light->GetAttenuationValues();
  return light->GetPositional() && (values[0] != 1.0 || values[1] != 0.0 || values[2] != 0.0);
}

bool HasGradientOpacity(vtkVolumeProperty* property)
{
  return property->HasGradientOpacity(0) && !property->GetDisableGradientOpacity(0);
}

auto AsTuple(const LightingRequirements& r)
{
  return std::tie(r.Optics, r.Lights, r.Technique, r.NearShadowRays, r.NearShadowSteps,
    r.Reflection, r.Gradient, r.GradientTexture, r.NoiseFading, r.Diffuse, r.Specular,
    r.TwoSidedLighting, r.Attenuation, r.GradientOpacity, r.ClippingPlanes, r.Cropping, r.Mask,
    r.Opacity, r.PreIntegrated, r.HalvedSteps, r.EmptySpaceSkipping, r.Counting);
}

// Which terms a material reflects, whatever the light.
struct ReflectedTerms
{
  bool Diffuse;
  bool Specular;
};

ReflectedTerms GetReflectedTerms(vtkVolumeProperty* property)
{
  const bool diffuse = property->GetDiffuse(0) > 0.0;
  const bool specular = property->GetSpecular(0) > 0.0;
  return { diffuse, specular && GetReflectionModel(property) != ReflectionModel::OrenNayar };
}

bool Brightens(vtkLight* light, const double color[3])
{
  return light->GetIntensity() > 0.0 && !IsBlack(color);
}

bool FadesNoise(vtkVolumeProperty* property)
{
  auto* material = vtkVolumeMaterial::SafeDownCast(property);
  return material && material->GetNoiseFading() > 0.0;
}

void AddLights(vtkLightCollection* lights, vtkVolumeProperty* property, LightingRequirements& needs)
{
  const ReflectedTerms terms = GetReflectedTerms(property);
  VisitLightsThatAreOn(lights,
    [&](vtkLight* light)
    {
      if (!LightMatters(light, property))
      {
        return;
      }
      const auto kind = static_cast<int>(GetLightKind(light));
      ++needs.Lights[kind][static_cast<int>(GetShadowKind(light))];
      needs.Diffuse = needs.Diffuse || (terms.Diffuse && !IsBlack(light->GetDiffuseColor()));
      needs.Specular = needs.Specular || (terms.Specular && !IsBlack(light->GetSpecularColor()));
      needs.Attenuation = needs.Attenuation || HasAttenuation(light);
    });
}

void AddEnvironment(vtkVolumeProperty* property, LightingRequirements& needs)
{
  const ReflectedTerms terms = GetReflectedTerms(property);
  needs.Diffuse = terms.Diffuse;
  needs.Specular = terms.Specular;
}

void AddReflection(const LightedScene& scene, LightingRequirements& needs)
{
  const ReflectionModel model = GetReflectionModel(scene.Property);
  AddLights(scene.Lights, scene.Property, needs);
  needs.TwoSidedLighting = scene.TwoSidedLighting && needs.GetNumberOfLights() > 0;
  if (model == ReflectionModel::ReflectionMap && scene.EnvironmentMap)
  {
    AddEnvironment(scene.Property, needs);
  }
  if (needs.Diffuse || needs.Specular)
  {
    needs.Reflection = model;
    needs.NoiseFading = FadesNoise(scene.Property);
  }
}
}

//------------------------------------------------------------------------------
bool LightingRequirements::operator==(const LightingRequirements& other) const
{
  return AsTuple(*this) == AsTuple(other);
}

//------------------------------------------------------------------------------
int LightingRequirements::GetNumberOfLights() const
{
  int count = 0;
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    count += this->GetNumberOfLights(static_cast<LightKind>(kind));
  }
  return count;
}

//------------------------------------------------------------------------------
int LightingRequirements::GetNumberOfLights(LightKind kind) const
{
  int count = 0;
  for (int lights : this->Lights[static_cast<int>(kind)])
  {
    count += lights;
  }
  return count;
}

//------------------------------------------------------------------------------
int LightingRequirements::GetNumberOfLights(ShadowKind shadow) const
{
  int count = 0;
  for (const auto& lightsOfKind : this->Lights)
  {
    count += lightsOfKind[static_cast<int>(shadow)];
  }
  return count;
}

//------------------------------------------------------------------------------
int LightingRequirements::GetNumberOfShadowedLights() const
{
  return this->GetNumberOfLights(ShadowKind::Soft) + this->GetNumberOfLights(ShadowKind::Hard);
}

//------------------------------------------------------------------------------
LightKind GetLightKind(vtkLight* light)
{
  if (!light->GetPositional())
  {
    return LightKind::Directional;
  }
  return light->GetConeAngle() < NoConeAngle ? LightKind::Spot : LightKind::Point;
}

//------------------------------------------------------------------------------
ShadowKind GetShadowKind(vtkLight* light)
{
  auto* volumeLight = vtkVolumeLight::SafeDownCast(light);
  return volumeLight ? static_cast<ShadowKind>(volumeLight->GetShadow()) : ShadowKind::None;
}

//------------------------------------------------------------------------------
ReflectionModel GetReflectionModel(vtkVolumeProperty* property)
{
  auto* material = vtkVolumeMaterial::SafeDownCast(property);
  return material ? static_cast<ReflectionModel>(material->GetReflectionModel())
                  : ReflectionModel::Phong;
}

//------------------------------------------------------------------------------
bool LightMatters(vtkLight* light, vtkVolumeProperty* property)
{
  const ReflectedTerms terms = GetReflectedTerms(property);
  return GetReflectionModel(property) != ReflectionModel::ReflectionMap &&
    ((terms.Diffuse && Brightens(light, light->GetDiffuseColor())) ||
      (terms.Specular && Brightens(light, light->GetSpecularColor())));
}

//------------------------------------------------------------------------------
LightingRequirements ComputeLightingRequirements(const LightedScene& scene)
{
  LightingRequirements needs;
  needs.GradientOpacity = HasGradientOpacity(scene.Property);
  needs.ClippingPlanes = scene.ClippingPlanes;
  needs.Cropping = scene.Cropping;
  needs.Mask = scene.Mask;
  needs.Opacity = scene.Opacity;
  // A mask or a region may cut a step anywhere.
  needs.PreIntegrated = scene.SteepOpacity && scene.LinearInterpolation && !scene.Mask &&
    scene.Cropping != CroppingKind::Regions;
  if (needs.PreIntegrated)
  {
    needs.Opacity = TransferFunctionLookup::Table;
  }
  needs.EmptySpaceSkipping = scene.EmptySpace;
  const OpticalModel byShade = scene.Property->GetShade(0) != 0 ? OpticalModel::SingleScattering
                                                                : OpticalModel::AbsorptionEmission;
  needs.Optics = scene.Optics.value_or(byShade);
  if (needs.IsShaded())
  {
    AddReflection(scene, needs);
  }
  if (needs.NeedsGradient())
  {
    needs.Gradient = scene.Gradient;
    needs.GradientTexture = scene.GradientTexture;
  }
  return needs;
}

//------------------------------------------------------------------------------
std::array<double, 3> ComputeAmbientLight(vtkLightCollection* lights)
{
  std::array<double, 3> sum = { 0.0, 0.0, 0.0 };
  bool anyOn = false;
  bool allPlainAndBlack = true;
  VisitLightsThatAreOn(lights,
    [&](vtkLight* light)
    {
      anyOn = true;
      const double* color = light->GetAmbientColor();
      allPlainAndBlack = allPlainAndBlack && !vtkVolumeLight::SafeDownCast(light) && IsBlack(color);
      for (int channel = 0; channel < 3; ++channel)
      {
        sum[channel] += color[channel] * light->GetIntensity();
      }
    });
  if (anyOn && allPlainAndBlack)
  {
    sum.fill(1.0);
  }
  return sum;
}

}
