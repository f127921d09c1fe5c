#include "ShaderSource.h"

#include "GlslBoxVertex.h"
#include "GlslCompositeAccumulation.h"
#include "GlslEmptyAroundMap.h"
#include "GlslEmptyAroundNone.h"
#include "GlslLightSpace.h"
#include "GlslMapRay.h"
#include "GlslOpacityMapFill.h"
#include "GlslShadowMapFill.h"
#include "GlslShadowRay.h"
#include "GlslShadowStep.h"
#include "GlslShadowVolumeFill.h"
#include "GlslViewTiles.h"
#include "OpacityMapPlan.h"
#include "ShaderSnippets.h"

#include <array>

namespace penumbra
{
namespace
{
using Needs = LightingRequirements;

std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

// How many lights of each kind and shadow state there are and where each group begins.
std::string DefineLightGroups(const Needs& needs)
{
  const std::array<std::string, NumberOfLightKinds> kinds = { "DIRECTIONAL", "POINT", "SPOT" };
  std::string text = Define("LIGHTS", needs.GetNumberOfLights());
  text += Define("SHADOWED_LIGHTS", needs.GetNumberOfShadowedLights());
  int first = 0;
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    const auto& counts = needs.Lights[kind];
    const std::string& name = kinds[kind];
    const int unshadowed = counts[static_cast<int>(ShadowKind::None)];
    const int soft = counts[static_cast<int>(ShadowKind::Soft)];
    const int hard = counts[static_cast<int>(ShadowKind::Hard)];
    text += Define(name + "_LIGHTS", unshadowed + soft + hard);
    text += Define(name + "_UNSHADOWED", unshadowed);
    text += Define(name + "_SOFT", soft);
    text += Define(name + "_HARD", hard);
    text += Define(name + "_FIRST", first);
    text += Define(name + "_SOFT_FIRST", first + unshadowed);
    text += Define(name + "_HARD_FIRST", first + unshadowed + soft);
    first += unshadowed + soft + hard;
  }
  return text;
}

const char* const FragmentHead = "//VTK::System::Dec\n//VTK::Output::Dec\n\n";

// What matter is, and what a cache of shadows makes of it.
std::string GetFillSource(const Needs& needs, std::initializer_list<const char*> snippets)
{
  const Needs matter = GetMatterRequirements(needs);
  std::string source = FragmentHead;
  source += Define("CLIPPING_PLANES", matter.ClippingPlanes);
  source += Define("WHOLE_SEGMENTS", matter.NeedsWholeSegments() ? 1 : 0);
  source += GetMatterSnippets(matter);
  for (const char* snippet : snippets)
  {
    source += "\n";
    source += snippet;
  }
  return source;
}
}

//------------------------------------------------------------------------------
std::string GetVertexShaderSource()
{
  return GlslBoxVertex;
}

//------------------------------------------------------------------------------
std::string GetGeometryShaderSource(const LightingRequirements& requirements)
{
  return requirements.EmptySpaceSkipping ? GlslViewTiles : "";
}

//------------------------------------------------------------------------------
std::string GetFragmentShaderSource(const LightingRequirements& requirements, bool continued)
{
  std::string source = FragmentHead;
  source += DefineLightGroups(requirements);
  source += Define("NEAR_SHADOW_STEPS", requirements.NearShadowSteps);
  source += Define("CLIPPING_PLANES", requirements.ClippingPlanes);
  source += Define("WHOLE_SEGMENTS", requirements.NeedsWholeSegments() ? 1 : 0);
  source += GetMatterSnippets(requirements);
  source += GetPictureSnippets(requirements, continued);
  return source;
}

//------------------------------------------------------------------------------
LightingRequirements GetMatterRequirements(const LightingRequirements& requirements)
{
  LightingRequirements matter;
  matter.Optics = OpticalModel::Absorption;
  matter.ClippingPlanes = requirements.ClippingPlanes;
  matter.Cropping = requirements.Cropping;
  matter.Mask = requirements.Mask;
  matter.Opacity = requirements.Opacity;
  matter.PreIntegrated = requirements.PreIntegrated;
  matter.EmptySpaceSkipping = requirements.EmptySpaceSkipping;
  matter.GradientOpacity = requirements.GradientOpacity;
  if (matter.GradientOpacity)
  {
    matter.Gradient = requirements.Gradient;
    matter.GradientTexture = requirements.GradientTexture;
  }
  return matter;
}

//------------------------------------------------------------------------------
std::string GetShadowVolumeSource(const LightingRequirements& requirements)
{
  const char* const emptyAround =
    requirements.EmptySpaceSkipping ? GlslEmptyAroundMap : GlslEmptyAroundNone;
  return GetFillSource(
    requirements, { GlslShadowStep, GlslShadowRay, emptyAround, GlslShadowVolumeFill });
}

//------------------------------------------------------------------------------
std::string GetShadowMapSource(const LightingRequirements& requirements)
{
  return GetFillSource(
    requirements, { GlslShadowStep, GlslShadowRay, GlslLightSpace, GlslMapRay, GlslShadowMapFill });
}

//------------------------------------------------------------------------------
std::string GetOpacityMapSource(const LightingRequirements& requirements)
{
  const std::string layers = Define("LAYERS_PER_DRAW", OpacityMapPlan::LayersPerDraw);
  return GetFillSource(requirements,
    { layers.c_str(), GlslShadowStep, GlslLightSpace, GlslMapRay, GlslOpacityMapFill });
}

//------------------------------------------------------------------------------
std::string GetCompositeShaderSource()
{
  return GlslCompositeAccumulation;
}

}
