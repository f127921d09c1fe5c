#include "LightingRequirements.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkVolumeLight.h"
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
  return std::tie(r.Shade, r.Lights, r.Technique, r.Reflection, r.Gradient, r.Diffuse, r.Specular,
    r.TwoSidedLighting, r.Attenuation, r.GradientOpacity, r.ClippingPlanes, r.Cropping, r.Mask,
    r.Opacity);
}

RequirementEntry Flag(const std::string& name, bool needed)
{
  return { name, needed ? "yes" : "no", needed };
}

RequirementEntry Count(const std::string& name, int count)
{
  return { name, std::to_string(count), count > 0 };
}

RequirementEntry Choice(const std::string& name, const std::string& value, bool needed)
{
  return { name, needed ? value : "none", needed };
}

const char* GetLookupName(TransferFunctionLookup lookup)
{
  return lookup == TransferFunctionLookup::Table ? "table" : "points";
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
std::vector<RequirementEntry> LightingRequirements::GetEntries() const
{
  const bool normal = this->NeedsNormal();
  const int positional =
    this->GetNumberOfLights(LightKind::Point) + this->GetNumberOfLights(LightKind::Spot);
  return {
    Choice("opacity", GetLookupName(this->Opacity), true),
    Flag("gradient opacity", this->GradientOpacity),
    Count("clipping planes", this->ClippingPlanes),
    Choice("cropping", this->Cropping == CroppingKind::Regions ? "regions" : "box",
      this->Cropping != CroppingKind::None),
    Flag("mask", this->Mask),
    Flag("shading", this->Shade),
    Choice("gradient", "central differences", this->NeedsGradient()),
    Choice("reflection model", "phong", normal),
    Flag("diffuse term", this->Diffuse),
    Flag("specular term", this->Specular),
    Flag("two-sided lighting", this->TwoSidedLighting),
    Count("directional lights", this->GetNumberOfLights(LightKind::Directional)),
    Count("point lights", this->GetNumberOfLights(LightKind::Point)),
    Count("spot lights", this->GetNumberOfLights(LightKind::Spot)),
    Flag("attenuation", positional > 0 && this->Attenuation),
    Count("soft shadows", this->GetNumberOfLights(ShadowKind::Soft)),
    Count("hard shadows", this->GetNumberOfLights(ShadowKind::Hard)),
    Choice("shadow technique", "rays", this->GetNumberOfShadowedLights() > 0),
  };
}

//------------------------------------------------------------------------------
std::vector<std::string> LightingRequirements::GetLeftOut() const
{
  std::vector<std::string> names;
  for (const RequirementEntry& entry : this->GetEntries())
  {
    if (!entry.Needed)
    {
      names.push_back(entry.Name);
    }
  }
  return names;
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
bool LightsMatter(vtkLight* light, double diffuse, double specular)
{
  return light->GetIntensity() > 0.0 &&
    ((diffuse > 0.0 && !IsBlack(light->GetDiffuseColor())) ||
      (specular > 0.0 && !IsBlack(light->GetSpecularColor())));
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
  needs.Shade = scene.Property->GetShade(0) != 0;
  if (!needs.Shade)
  {
    return needs;
  }
  const double diffuse = scene.Property->GetDiffuse(0);
  const double specular = scene.Property->GetSpecular(0);
  VisitLightsThatAreOn(scene.Lights,
    [&](vtkLight* light)
    {
      if (!LightsMatter(light, diffuse, specular))
      {
        return;
      }
      const auto kind = static_cast<int>(GetLightKind(light));
      ++needs.Lights[kind][static_cast<int>(GetShadowKind(light))];
      needs.Diffuse = needs.Diffuse || (diffuse > 0.0 && !IsBlack(light->GetDiffuseColor()));
      needs.Specular = needs.Specular || (specular > 0.0 && !IsBlack(light->GetSpecularColor()));
      needs.Attenuation = needs.Attenuation || HasAttenuation(light);
    });
  needs.TwoSidedLighting = scene.TwoSidedLighting && needs.NeedsNormal();
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
