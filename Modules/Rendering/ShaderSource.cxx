#include "ShaderSource.h"

#include "GlslAccumulationNone.h"
#include "GlslAccumulationPrevious.h"
#include "GlslAttenuationDistance.h"
#include "GlslAttenuationNone.h"
#include "GlslBoxInterval.h"
#include "GlslBoxVertex.h"
#include "GlslClippingNone.h"
#include "GlslClippingPlanes.h"
#include "GlslColorPoints.h"
#include "GlslColorTable.h"
#include "GlslCompositeAccumulation.h"
#include "GlslCompositingAdd.h"
#include "GlslCompositingOver.h"
#include "GlslCosines.h"
#include "GlslCosinesPreferred.h"
#include "GlslCroppingBox.h"
#include "GlslCroppingRegions.h"
#include "GlslDeclarations.h"
#include "GlslDiffuseNone.h"
#include "GlslDiffuseTerm.h"
#include "GlslEmptySpaceMap.h"
#include "GlslEmptySpaceNone.h"
#include "GlslEnvironmentDiffuse.h"
#include "GlslEnvironmentDiffuseNone.h"
#include "GlslEnvironmentSpecular.h"
#include "GlslEnvironmentSpecularNone.h"
#include "GlslFadingNoise.h"
#include "GlslFadingNone.h"
#include "GlslFresnel.h"
#include "GlslGradientBackward.h"
#include "GlslGradientCentral.h"
#include "GlslGradientForward.h"
#include "GlslGradientOpacityNone.h"
#include "GlslGradientOpacityTable.h"
#include "GlslGradientSobel.h"
#include "GlslGradientTexture.h"
#include "GlslLightFalloff.h"
#include "GlslLightPoint.h"
#include "GlslLights.h"
#include "GlslLightsDirectional.h"
#include "GlslLightsPoint.h"
#include "GlslLightsSpot.h"
#include "GlslMarchSamples.h"
#include "GlslMarchToMatter.h"
#include "GlslMaskBinary.h"
#include "GlslMaskNone.h"
#include "GlslNormal.h"
#include "GlslOpacityIntegral.h"
#include "GlslOpacityPoints.h"
#include "GlslOpacityTable.h"
#include "GlslReflectionBlinnPhong.h"
#include "GlslReflectionCookTorrance.h"
#include "GlslReflectionOrenNayar.h"
#include "GlslReflectionPhong.h"
#include "GlslReflectionWard.h"
#include "GlslReflectionWardAnisotropic.h"
#include "GlslSegmentColor.h"
#include "GlslSegmentColorIntegral.h"
#include "GlslSegmentColorNone.h"
#include "GlslSegmentDepth.h"
#include "GlslSegmentIntegral.h"
#include "GlslShadingAmbient.h"
#include "GlslShadingBlack.h"
#include "GlslShadingEnvironment.h"
#include "GlslShadingLights.h"
#include "GlslShadingNone.h"
#include "GlslShadowHardRay.h"
#include "GlslShadowRay.h"
#include "GlslShadowSoftRay.h"
#include "GlslSidesOne.h"
#include "GlslSidesTwo.h"
#include "GlslSpecularFresnel.h"
#include "GlslSpecularNone.h"
#include "GlslSpecularTerm.h"
#include "GlslTransmittance.h"
#include "GlslViewRay.h"
#include "GlslViewRaySteps.h"

#include <array>

namespace penumbra
{
namespace
{
using Needs = LightingRequirements;

struct Snippet
{
  const char* Source;
  bool (*Needed)(const Needs& needs, bool continued);
};

bool Always(const Needs&, bool)
{
  return true;
}

bool IsPositional(const Needs& needs)
{
  return needs.GetNumberOfLights(LightKind::Point) + needs.GetNumberOfLights(LightKind::Spot) > 0;
}

bool Lit(const Needs& needs)
{
  return needs.GetNumberOfLights() > 0;
}

template <ReflectionModel Model>
bool ReflectsBy(const Needs& needs, bool)
{
  return Lit(needs) && needs.Reflection == Model;
}

template <GradientEstimator Estimator>
bool EstimatesBy(const Needs& needs, bool)
{
  return needs.NeedsGradient() && !needs.GradientTexture && needs.Gradient == Estimator;
}

bool Shadowed(const Needs& needs)
{
  return needs.GetNumberOfShadowedLights() > 0;
}

// In GLSL order: what is used stands before its use. Alternatives stand together, and exactly one
// of them is needed.
const Snippet FragmentSnippets[] = {
  { GlslDeclarations, Always },
  { GlslBoxInterval, Always },
  { GlslTransmittance, Always },
  { GlslOpacityTable,
    [](const Needs& n, bool)
    { return !n.PreIntegrated && n.Opacity == TransferFunctionLookup::Table; } },
  { GlslOpacityPoints,
    [](const Needs& n, bool) { return n.Opacity == TransferFunctionLookup::Points; } },
  { GlslColorTable,
    [](const Needs& n, bool)
    { return n.NeedsColor() && !n.PreIntegrated && n.Opacity == TransferFunctionLookup::Table; } },
  { GlslColorPoints,
    [](const Needs& n, bool)
    { return n.NeedsColor() && n.Opacity == TransferFunctionLookup::Points; } },
  { GlslOpacityIntegral, [](const Needs& n, bool) { return n.PreIntegrated; } },
  { GlslClippingNone, [](const Needs& n, bool) { return n.ClippingPlanes == 0; } },
  { GlslClippingPlanes, [](const Needs& n, bool) { return n.ClippingPlanes > 0; } },
  { GlslCroppingBox,
    [](const Needs& n, bool) { return !n.PreIntegrated && n.Cropping != CroppingKind::Regions; } },
  { GlslCroppingRegions, [](const Needs& n, bool) { return n.Cropping == CroppingKind::Regions; } },
  { GlslMaskNone, [](const Needs& n, bool) { return !n.PreIntegrated && !n.Mask; } },
  { GlslMaskBinary, [](const Needs& n, bool) { return n.Mask; } },
  { GlslGradientCentral, EstimatesBy<GradientEstimator::CentralDifferences> },
  { GlslGradientForward, EstimatesBy<GradientEstimator::ForwardDifferences> },
  { GlslGradientBackward, EstimatesBy<GradientEstimator::BackwardDifferences> },
  { GlslGradientSobel, EstimatesBy<GradientEstimator::Sobel> },
  { GlslGradientTexture,
    [](const Needs& n, bool) { return n.NeedsGradient() && n.GradientTexture; } },
  { GlslGradientOpacityNone, [](const Needs& n, bool) { return !n.GradientOpacity; } },
  { GlslGradientOpacityTable, [](const Needs& n, bool) { return n.GradientOpacity; } },
  { GlslSegmentDepth, [](const Needs& n, bool) { return !n.PreIntegrated; } },
  { GlslSegmentIntegral, [](const Needs& n, bool) { return n.PreIntegrated; } },
  { GlslEmptySpaceNone, [](const Needs& n, bool) { return !n.EmptySpaceSkipping; } },
  { GlslEmptySpaceMap, [](const Needs& n, bool) { return n.EmptySpaceSkipping; } },
  { GlslSegmentColorNone, [](const Needs& n, bool) { return !n.NeedsColor(); } },
  { GlslSegmentColor, [](const Needs& n, bool) { return n.NeedsColor() && !n.PreIntegrated; } },
  { GlslSegmentColorIntegral,
    [](const Needs& n, bool) { return n.NeedsColor() && n.PreIntegrated; } },
  { GlslNormal, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { GlslFadingNone, [](const Needs& n, bool) { return n.NeedsNormal() && !n.NoiseFading; } },
  { GlslFadingNoise, [](const Needs& n, bool) { return n.NeedsNormal() && n.NoiseFading; } },
  { GlslSidesOne, [](const Needs& n, bool) { return Lit(n) && !n.TwoSidedLighting; } },
  { GlslSidesTwo, [](const Needs& n, bool) { return Lit(n) && n.TwoSidedLighting; } },
  { GlslCosines, [](const Needs& n, bool) { return Lit(n) && !n.HasPreferredDirection(); } },
  { GlslCosinesPreferred,
    [](const Needs& n, bool) { return Lit(n) && n.HasPreferredDirection(); } },
  { GlslReflectionPhong, ReflectsBy<ReflectionModel::Phong> },
  { GlslReflectionBlinnPhong, ReflectsBy<ReflectionModel::BlinnPhong> },
  { GlslReflectionOrenNayar, ReflectsBy<ReflectionModel::OrenNayar> },
  { GlslReflectionWard, ReflectsBy<ReflectionModel::Ward> },
  { GlslReflectionWardAnisotropic, ReflectsBy<ReflectionModel::WardAnisotropic> },
  { GlslReflectionCookTorrance, ReflectsBy<ReflectionModel::CookTorrance> },
  { GlslDiffuseNone, [](const Needs& n, bool) { return Lit(n) && !n.Diffuse; } },
  { GlslDiffuseTerm, [](const Needs& n, bool) { return Lit(n) && n.Diffuse; } },
  { GlslSpecularNone, [](const Needs& n, bool) { return Lit(n) && !n.Specular; } },
  { GlslSpecularTerm,
    [](const Needs& n, bool) { return Lit(n) && n.Specular && !n.HasFresnelTerm(); } },
  { GlslFresnel, [](const Needs& n, bool) { return Lit(n) && n.Specular && n.HasFresnelTerm(); } },
  { GlslSpecularFresnel,
    [](const Needs& n, bool) { return Lit(n) && n.Specular && n.HasFresnelTerm(); } },
  { GlslLights, [](const Needs& n, bool) { return Lit(n); } },
  { GlslShadowRay, [](const Needs& n, bool) { return Shadowed(n); } },
  { GlslShadowSoftRay,
    [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Soft) > 0; } },
  { GlslShadowHardRay,
    [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Hard) > 0; } },
  { GlslLightsDirectional,
    [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Directional) > 0; } },
  { GlslLightFalloff, [](const Needs& n, bool) { return IsPositional(n); } },
  { GlslAttenuationNone, [](const Needs& n, bool) { return IsPositional(n) && !n.Attenuation; } },
  { GlslAttenuationDistance,
    [](const Needs& n, bool) { return IsPositional(n) && n.Attenuation; } },
  { GlslLightPoint, [](const Needs& n, bool) { return IsPositional(n); } },
  { GlslLightsPoint,
    [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Point) > 0; } },
  { GlslLightsSpot, [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Spot) > 0; } },
  { GlslEnvironmentDiffuseNone,
    [](const Needs& n, bool) { return n.NeedsEnvironment() && !n.Diffuse; } },
  { GlslEnvironmentDiffuse,
    [](const Needs& n, bool) { return n.NeedsEnvironment() && n.Diffuse; } },
  { GlslEnvironmentSpecularNone,
    [](const Needs& n, bool) { return n.NeedsEnvironment() && !n.Specular; } },
  { GlslEnvironmentSpecular,
    [](const Needs& n, bool) { return n.NeedsEnvironment() && n.Specular; } },
  { GlslShadingBlack, [](const Needs& n, bool) { return !n.NeedsColor(); } },
  { GlslShadingNone, [](const Needs& n, bool) { return n.NeedsColor() && !n.IsShaded(); } },
  { GlslShadingAmbient, [](const Needs& n, bool) { return n.IsShaded() && !n.NeedsNormal(); } },
  { GlslShadingEnvironment, [](const Needs& n, bool) { return n.NeedsEnvironment(); } },
  { GlslShadingLights, [](const Needs& n, bool) { return Lit(n); } },
  { GlslCompositingAdd, [](const Needs& n, bool) { return n.Optics == OpticalModel::Emission; } },
  { GlslCompositingOver, [](const Needs& n, bool) { return n.Optics != OpticalModel::Emission; } },
  { GlslAccumulationNone, [](const Needs&, bool continued) { return !continued; } },
  { GlslAccumulationPrevious, [](const Needs&, bool continued) { return continued; } },
  { GlslViewRaySteps, Always },
  { GlslMarchSamples, [](const Needs& n, bool) { return !n.NeedsNormal(); } },
  { GlslMarchToMatter, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { GlslViewRay, Always },
};

std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

// How many lights of each kind and shadow state there are and where each group begins.
std::string DefineLightGroups(const Needs& needs)
{
  const std::array<std::string, NumberOfLightKinds> kinds = { "DIRECTIONAL", "POINT", "SPOT" };
  std::string text = Define("LIGHTS", needs.GetNumberOfLights());
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
}

//------------------------------------------------------------------------------
std::string GetVertexShaderSource()
{
  return GlslBoxVertex;
}

//------------------------------------------------------------------------------
std::string GetFragmentShaderSource(const LightingRequirements& requirements, bool continued)
{
  std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\n\n";
  source += DefineLightGroups(requirements);
  source += Define("CLIPPING_PLANES", requirements.ClippingPlanes);
  source += Define("WHOLE_SEGMENTS", requirements.NeedsWholeSegments() ? 1 : 0);
  for (const Snippet& snippet : FragmentSnippets)
  {
    if (snippet.Needed(requirements, continued))
    {
      source += "\n";
      source += snippet.Source;
    }
  }
  return source;
}

//------------------------------------------------------------------------------
std::string GetCompositeShaderSource()
{
  return GlslCompositeAccumulation;
}

}
