#include "ShaderText.h"

#include <map>
#include <sstream>

namespace penumbra
{
namespace
{
const std::map<std::string, std::vector<std::string>> Symbols = {
  { "opacity", { "extinctionOf(", "colorOf(" } },
  { "gradient opacity", { "scene_gradientOpacity", "scene_gradientToTable" } },
  { "clipping planes", { "scene_clippingPlanes" } },
  { "mask", { "scene_mask", "maskShows" } },
  { "shading", { "scene_ambient" } },
  { "gradient", { "gradientAt" } },
  { "reflection model", { "diffuseReflection", "specularReflection", "normalOf", "litSide" } },
  { "diffuse term", { "scene_lightDiffuse" } },
  { "specular term", { "scene_lightSpecular", "scene_specularPower" } },
  { "two-sided lighting", { "nDotL < 0.0 ? -1.0 : 1.0" } },
  { "directional lights", { "directionalLight(", "addDirectionalLights(" } },
  { "point lights", { "addPointLights(" } },
  { "spot lights", { "spotLight(", "addSpotLights(", "scene_lightCone" } },
  { "attenuation", { "scene_lightAttenuation" } },
  { "soft shadows", { "softVisibility" } },
  { "hard shadows", { "hardVisibility" } },
  { "shadow technique", { "opticalDepth", "scene_shadowSampleDistance" } },
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
      wrong += Check(text, { "int light = " + kinds[kind] + shadows[shadow] + "_FIRST;" },
        requirements.Lights[kind][shadow] > 0);
    }
  }
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
    if (entry.Name != "cropping")
    {
      wrong += Check(text, GetSymbols(entry.Name), entry.Needed);
    }
  }
  const bool table = requirements.Opacity == TransferFunctionLookup::Table;
  wrong += Check(text, { "scene_extinction", "scene_color", "scene_tableCoordinate" }, table);
  wrong += Check(text, { "scene_points", "scene_pointSearchSteps" }, !table);
  wrong += FindWrongLoops(requirements, text);
  wrong += Check(text, RegionSymbols, requirements.Cropping == CroppingKind::Regions);
  return wrong;
}

}
