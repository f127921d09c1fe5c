#include "ShaderSnippets.h"

#include "GlslAccumulationNone.h"
#include "GlslAccumulationPrevious.h"
#include "GlslAttenuationDistance.h"
#include "GlslAttenuationNone.h"
#include "GlslBoxInterval.h"
#include "GlslClippingNone.h"
#include "GlslClippingPlanes.h"
#include "GlslColorPoints.h"
#include "GlslColorTable.h"
#include "GlslCompositingAdd.h"
#include "GlslCompositingOver.h"
#include "GlslCosines.h"
#include "GlslCosinesPreferred.h"
#include "GlslCountingNone.h"
#include "GlslCountingSteps.h"
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
#include "GlslKeptDarknessDeepMap.h"
#include "GlslKeptDarknessOpacityMap.h"
#include "GlslLightFalloff.h"
#include "GlslLightMapPlace.h"
#include "GlslLightPoint.h"
#include "GlslLightSpace.h"
#include "GlslLights.h"
#include "GlslLightsDirectional.h"
#include "GlslLightsPoint.h"
#include "GlslLightsSpot.h"
#include "GlslMarchSamples.h"
#include "GlslMarchToMatter.h"
#include "GlslMaskBinary.h"
#include "GlslMaskNone.h"
#include "GlslNearShadowNone.h"
#include "GlslNearShadowRay.h"
#include "GlslNearShadowSteps.h"
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
#include "GlslSegmentPieces.h"
#include "GlslSegmentWhole.h"
#include "GlslShadingAmbient.h"
#include "GlslShadingBlack.h"
#include "GlslShadingEnvironment.h"
#include "GlslShadingLights.h"
#include "GlslShadingNone.h"
#include "GlslShadowDepthMap.h"
#include "GlslShadowDepthRay.h"
#include "GlslShadowDepthVolume.h"
#include "GlslShadowHard.h"
#include "GlslShadowHardEdge.h"
#include "GlslShadowHardFiltered.h"
#include "GlslShadowRay.h"
#include "GlslShadowSoft.h"
#include "GlslShadowStep.h"
#include "GlslSidesOne.h"
#include "GlslSidesTwo.h"
#include "GlslSpecularFresnel.h"
#include "GlslSpecularNone.h"
#include "GlslSpecularTerm.h"
#include "GlslStepHalves.h"
#include "GlslStepWhole.h"
#include "GlslTransmittance.h"
#include "GlslViewRay.h"
#include "GlslViewRaySteps.h"

#include <cstddef>

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

template <ShadowTechnique Technique>
bool ShadowedBy(const Needs& needs, bool)
{
  return Shadowed(needs) && needs.Technique == Technique;
}

bool KeepsShadows(const Needs& needs)
{
  return Shadowed(needs) && needs.Technique != ShadowTechnique::Rays;
}

// A map of first hits tells hard shadows only; soft ones take a deep map then.
bool LooksUpMaps(const Needs& needs, bool)
{
  return Shadowed(needs) &&
    (needs.Technique == ShadowTechnique::Map || needs.Technique == ShadowTechnique::DeepMap ||
      needs.Technique == ShadowTechnique::OpacityMap);
}

// In GLSL order: what is used stands before its use. Alternatives stand together, and exactly one
// of them is needed. First what matter is, for view rays and shadow rays alike.
const Snippet MatterSnippets[] = {
  { GlslDeclarations, Always },
  { GlslCountingNone, [](const Needs& n, bool) { return !n.Counting; } },
  { GlslCountingSteps, [](const Needs& n, bool) { return n.Counting; } },
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
};

// Then how it is lit and seen.
const Snippet PictureSnippets[] = {
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
  { GlslShadowStep, [](const Needs& n, bool) { return n.NeedsShadowRays(); } },
  { GlslShadowRay,
    [](const Needs& n, bool) { return n.NeedsShadowRays() && n.NearShadowSteps == 0; } },
  { GlslNearShadowNone,
    [](const Needs& n, bool) { return KeepsShadows(n) && !n.NeedsShadowRays(); } },
  { GlslNearShadowSteps,
    [](const Needs& n, bool) { return KeepsShadows(n) && n.NearShadowSteps > 0; } },
  { GlslNearShadowRay, [](const Needs& n, bool) { return KeepsShadows(n) && n.NearShadowRays; } },
  { GlslShadowDepthRay, ShadowedBy<ShadowTechnique::Rays> },
  { GlslShadowDepthVolume, ShadowedBy<ShadowTechnique::Volume> },
  { GlslLightSpace, LooksUpMaps },
  { GlslLightMapPlace, LooksUpMaps },
  { GlslKeptDarknessDeepMap,
    [](const Needs& n, bool c)
    { return LooksUpMaps(n, c) && n.Technique != ShadowTechnique::OpacityMap; } },
  { GlslKeptDarknessOpacityMap, ShadowedBy<ShadowTechnique::OpacityMap> },
  { GlslShadowDepthMap, LooksUpMaps },
  { GlslShadowSoft,
    [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Soft) > 0; } },
  { GlslShadowHardEdge,
    [](const Needs& n, bool)
    { return n.GetNumberOfLights(ShadowKind::Hard) > 0 && n.Technique != ShadowTechnique::Map; } },
  { GlslShadowHardFiltered,
    [](const Needs& n, bool)
    { return n.GetNumberOfLights(ShadowKind::Hard) > 0 && n.Technique == ShadowTechnique::Map; } },
  { GlslShadowHard,
    [](const Needs& n, bool) { return n.GetNumberOfLights(ShadowKind::Hard) > 0; } },
  { GlslLightsDirectional,
    [](const Needs& n, bool) { return n.GetNumberOfLights(LightKind::Directional) > 0; } },
  { GlslLightFalloff, [](const Needs& n, bool) { return n.NeedsLightPositions(); } },
  { GlslAttenuationNone,
    [](const Needs& n, bool) { return n.NeedsLightPositions() && !n.Attenuation; } },
  { GlslAttenuationDistance,
    [](const Needs& n, bool) { return n.NeedsLightPositions() && n.Attenuation; } },
  { GlslLightPoint, [](const Needs& n, bool) { return n.NeedsLightPositions(); } },
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
  { GlslSegmentWhole, [](const Needs& n, bool) { return n.NeedsNormal() && !n.PreIntegrated; } },
  { GlslSegmentPieces, [](const Needs& n, bool) { return n.NeedsNormal() && n.PreIntegrated; } },
  { GlslStepWhole, [](const Needs& n, bool) { return n.NeedsNormal() && !n.HalvedSteps; } },
  { GlslStepHalves, [](const Needs& n, bool) { return n.NeedsNormal() && n.HalvedSteps; } },
  { GlslMarchSamples, [](const Needs& n, bool) { return !n.NeedsNormal(); } },
  { GlslMarchToMatter, [](const Needs& n, bool) { return n.NeedsNormal(); } },
  { GlslViewRay, Always },
};

// Those of the snippets that are needed, each after an empty line.
template <std::size_t Size>
std::string Join(const Snippet (&snippets)[Size], const Needs& needs, bool continued)
{
  std::string source;
  for (const Snippet& snippet : snippets)
  {
    if (snippet.Needed(needs, continued))
    {
      source += "\n";
      source += snippet.Source;
    }
  }
  return source;
}
}

//------------------------------------------------------------------------------
std::string GetMatterSnippets(const LightingRequirements& requirements)
{
  return Join(MatterSnippets, requirements, false);
}

//------------------------------------------------------------------------------
std::string GetPictureSnippets(const LightingRequirements& requirements, bool continued)
{
  return Join(PictureSnippets, requirements, continued);
}

}
