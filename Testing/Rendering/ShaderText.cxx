#include "ShaderText.h"

#include <map>
#include <set>
#include <sstream>

namespace penumbra
{
namespace
{
const std::map<std::string, std::vector<std::string>> Symbols = {
  { "optical model", { "compositingWeight(" } },
  { "opacity", { "RayEnd rayEndAt(" } },
  { "pre-integration", { "scene_integralRounding", "meanExtinction" } },
  { "halved steps", { "HalvedWeight", "bool second" } },
  { "empty-space skipping", { "scene_emptyCubes", "stepsToFarSide" } },
  { "gradient opacity", { "scene_gradientOpacity", "scene_gradientToTable" } },
  { "clipping planes", { "scene_clippingPlanes" } },
  { "mask", { "scene_mask", "maskShows" } },
  { "shading", { "scene_ambient" } },
  { "gradient", { "gradientAt" } },
  { "gradient texture", { "scene_gradients" } },
  { "reflection model", { "normalOf", "scene_gradientToWorld" } },
  { "fresnel term", { "fresnelReflectance", "scene_indexOfRefraction" } },
  { "preferred direction", { "scene_preferredDirection", "pDotN" } },
  { "noise fading", { "scene_gradientToNoise", "scene_fadedReflection", "certainty" } },
  { "two-sided lighting", { "nDotL < 0.0 ? -1.0 : 1.0" } },
  { "directional lights", { "directionalLight(", "addDirectionalLights(" } },
  { "point lights", { "addPointLights(" } },
  { "spot lights", { "spotLight(", "addSpotLights(", "scene_lightCone" } },
  { "attenuation", { "scene_lightAttenuation" } },
  { "soft shadows", { "softVisibility" } },
  { "hard shadows", { "hardVisibility" } },
  { "shadow technique", { "ShadowSegment towardsLight" } },
  { "shadow rays", { "shadowStepDepth", "scene_shadowSampleDistance" } },
};

// What one reflection model's source has and no other's.
const std::map<ReflectionModel, std::string> ModelSymbols = {
  { ReflectionModel::Phong, "rDotV" },
  { ReflectionModel::BlinnPhong, "pow(nDotH" },
  { ReflectionModel::OrenNayar, "azimuth" },
  { ReflectionModel::Ward, "slope / variance" },
  { ReflectionModel::WardAnisotropic, "along2" },
  { ReflectionModel::CookTorrance, "beckmannDistribution" },
};

const std::map<GradientEstimator, std::string> EstimatorSymbols = {
  { GradientEstimator::CentralDifferences, "0.5 *\n    vec3(texture(scene_scalars" },
  { GradientEstimator::ForwardDifferences, ".r - here" },
  { GradientEstimator::BackwardDifferences, "here - texture(" },
  { GradientEstimator::Sobel, "rowAt" },
};

// A box needs no code: it is the box that rays are cut to. Regions do.
const std::vector<std::string> RegionSymbols = { "scene_croppingFlags", "croppingShows" };

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string Check(const std::string& text, const std::vector<std::string>& symbols, bool needed)
{
  std::string wrong;
  for (const std::string& symbol : symbols)
  {
    if (Contains(text, symbol) != needed)
    {
      wrong += (needed ? "lacks " : "has ") + symbol + "\n";
    }
  }
  return wrong;
}

// What is kept of shadows is looked up in one place.
std::string FindWrongTechniques(const LightingRequirements& requirements, const std::string& text)
{
  const auto shadowedBy = [&](ShadowTechnique technique)
  { return requirements.GetNumberOfShadowedLights() > 0 && requirements.Technique == technique; };
  const bool maps = shadowedBy(ShadowTechnique::Map) || shadowedBy(ShadowTechnique::DeepMap);
  const bool layers = shadowedBy(ShadowTechnique::OpacityMap);
  const bool hard = requirements.GetNumberOfLights(ShadowKind::Hard) > 0;
  return Check(
           text, { "uniform sampler3D scene_shadowVolume;" }, shadowedBy(ShadowTechnique::Volume)) +
    Check(text, { "uniform sampler3D scene_shadowMaps;" }, maps) +
    Check(text, { "uniform sampler3D scene_opacityMaps;" }, layers) +
    Check(text, { "lightMapPlace(" }, maps || layers) +
    Check(text, { "1.0 - keptDarkness(" }, hard && shadowedBy(ShadowTechnique::Map)) +
    Check(text, { "ThinnestShadow" }, hard && requirements.Technique != ShadowTechnique::Map);
}

// Each kind and shadow state has a loop of its own.
std::string FindWrongLoops(const LightingRequirements& requirements, const std::string& text)
{
  const std::string kinds[] = { "DIRECTIONAL", "POINT", "SPOT" };
  const std::string shadows[] = { "", "_SOFT", "_HARD" };
  std::string wrong;
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    for (int shadow = 0; shadow < NumberOfShadowKinds; ++shadow)
    {
      wrong += Check(text, { "light = " + kinds[kind] + shadows[shadow] + "_FIRST;" },
        requirements.Lights[kind][shadow] > 0);
    }
  }
  return wrong;
}

// Terms are of the lights, or of an environment instead.
std::string FindWrongTerms(const LightingRequirements& requirements, const std::string& text)
{
  const bool mirrors = requirements.NeedsEnvironment();
  const bool lit = requirements.GetNumberOfLights() > 0;
  const bool diffuse = requirements.Diffuse;
  const bool specular = requirements.Specular;
  return Check(text, { "scene_lightDiffuse" }, lit && diffuse) +
    Check(text, { "scene_lightSpecular" }, lit && specular) +
    Check(text, { "diffuseReflection", "specularReflection", "litSide", "scene_reflection" }, lit) +
    Check(text, { "samplerCube scene_environmentDiffuse" }, mirrors && diffuse) +
    Check(text, { "samplerCube scene_environmentSpecular" }, mirrors && specular);
}

std::string FindWrongModels(const LightingRequirements& requirements, const std::string& text)
{
  std::string wrong;
  for (const auto& [model, symbol] : ModelSymbols)
  {
    wrong += Check(
      text, { symbol }, requirements.GetNumberOfLights() > 0 && requirements.Reflection == model);
  }
  const bool estimates = requirements.NeedsGradient() && !requirements.GradientTexture;
  for (const auto& [estimator, symbol] : EstimatorSymbols)
  {
    wrong += Check(text, { symbol }, estimates && requirements.Gradient == estimator);
  }
  wrong += Check(text, { "CompositedAlpha = 0.0" }, requirements.Optics == OpticalModel::Emission);
  return wrong;
}
}

//------------------------------------------------------------------------------
std::string GetCompiledText(const std::string& source)
{
  std::istringstream lines(source);
  std::map<std::string, int> defined;
  std::string compiled;
  bool leftOut = false;
  for (std::string line; std::getline(lines, line);)
  {
    line = line.substr(0, line.find("//"));
    std::istringstream words(line);
    std::string directive;
    std::string name;
    words >> directive >> name;
    if (directive == "#define")
    {
      words >> defined[name];
    }
    else if (directive == "#if")
    {
      char greater;
      int bound;
      words >> greater >> bound;
      leftOut = defined.at(name) <= bound;
    }
    else if (directive == "#endif")
    {
      leftOut = false;
    }
    else if (!leftOut)
    {
      compiled += line + "\n";
    }
  }
  return compiled;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetSymbols(const std::string& entryName)
{
  return Symbols.at(entryName);
}

//------------------------------------------------------------------------------
std::string FindWrongSymbols(const LightingRequirements& requirements, const std::string& source)
{
  const std::string text = GetCompiledText(source);
  std::string wrong;
  for (const RequirementEntry& entry : requirements.GetEntries())
  {
    // These are more than one line of text each, see below.
    const std::set<std::string> others = { "cropping", "diffuse term", "specular term",
      "environment maps", "colour" };
    if (others.count(entry.Name) == 0)
    {
      wrong += Check(text, GetSymbols(entry.Name), entry.Needed);
    }
  }
  const bool table = requirements.Opacity == TransferFunctionLookup::Table;
  const bool integrated = requirements.PreIntegrated;
  wrong += Check(text, { "scene_extinction", "scene_tableCoordinate" }, table);
  wrong += Check(text, { "uniform sampler1D scene_color;" }, table && requirements.NeedsColor());
  wrong += Check(text, { "scene_colorIntegral" }, integrated && requirements.NeedsColor());
  wrong += Check(text, { "extinctionOf(" }, !integrated);
  wrong += Check(text, { "colorOf(" }, !integrated && requirements.NeedsColor());
  wrong += Check(text, { "scene_points", "scene_pointSearchSteps" }, !table);
  wrong += FindWrongLoops(requirements, text);
  wrong += FindWrongTechniques(requirements, text);
  wrong += FindWrongTerms(requirements, text);
  wrong += FindWrongModels(requirements, text);
  wrong += Check(text, RegionSymbols, requirements.Cropping == CroppingKind::Regions);
  return wrong;
}

}
