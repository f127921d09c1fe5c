#include "LightingRequirements.h"

namespace penumbra
{
namespace
{
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

const char* GetName(OpticalModel model)
{
  static const char* const names[] = { "absorption", "emission", "absorption-emission",
    "single-scattering" };
  return names[static_cast<int>(model)];
}

const char* GetName(ReflectionModel model)
{
  static const char* const names[] = { "phong", "blinn-phong", "oren-nayar", "ward",
    "ward-anisotropic", "cook-torrance", "reflection-map" };
  return names[static_cast<int>(model)];
}

const char* GetName(GradientEstimator estimator)
{
  static const char* const names[] = { "central differences", "forward differences",
    "backward differences", "sobel" };
  return names[static_cast<int>(estimator)];
}

const char* GetLookupName(TransferFunctionLookup lookup)
{
  return lookup == TransferFunctionLookup::Table ? "table" : "points";
}
}

//------------------------------------------------------------------------------
const char* GetName(ShadowTechnique technique)
{
  static const char* const names[] = { "rays", "volume", "map", "deep-map", "opacity-map" };
  return names[static_cast<int>(technique)];
}

//------------------------------------------------------------------------------
std::vector<RequirementEntry> LightingRequirements::GetEntries() const
{
  const bool normal = this->NeedsNormal();
  const bool lit = this->GetNumberOfLights() > 0;
  const int environmentMaps =
    this->NeedsEnvironment() ? static_cast<int>(this->Diffuse) + this->Specular : 0;
  return {
    Choice("optical model", GetName(this->Optics), true),
    Choice("opacity", GetLookupName(this->Opacity), true),
    Flag("pre-integration", this->PreIntegrated),
    Flag("halved steps", this->HalvedSteps),
    Flag("empty-space skipping", this->EmptySpaceSkipping),
    Flag("colour", this->NeedsColor()),
    Flag("gradient opacity", this->GradientOpacity),
    Count("clipping planes", this->ClippingPlanes),
    Choice("cropping", this->Cropping == CroppingKind::Regions ? "regions" : "box",
      this->Cropping != CroppingKind::None),
    Flag("mask", this->Mask),
    Flag("shading", this->IsShaded()),
    Choice("gradient", GetName(this->Gradient), this->NeedsGradient()),
    Flag("gradient texture", this->NeedsGradient() && this->GradientTexture),
    Choice("reflection model", GetName(this->Reflection), normal),
    Flag("diffuse term", this->Diffuse),
    Flag("specular term", this->Specular),
    Flag("fresnel term", lit && this->Specular && this->HasFresnelTerm()),
    Flag("preferred direction", lit && this->HasPreferredDirection()),
    Count("environment maps", environmentMaps),
    Flag("noise fading", this->NoiseFading),
    Flag("two-sided lighting", this->TwoSidedLighting),
    Count("directional lights", this->GetNumberOfLights(LightKind::Directional)),
    Count("point lights", this->GetNumberOfLights(LightKind::Point)),
    Count("spot lights", this->GetNumberOfLights(LightKind::Spot)),
    Flag("attenuation", this->NeedsLightPositions() && this->Attenuation),
    Count("soft shadows", this->GetNumberOfLights(ShadowKind::Soft)),
    Count("hard shadows", this->GetNumberOfLights(ShadowKind::Hard)),
    Choice("shadow technique", GetName(this->Technique), this->GetNumberOfShadowedLights() > 0),
    Flag("shadow rays", this->NeedsShadowRays()),
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

}
