#include "Catch.h"
#include "LightingRequirements.h"

#include <algorithm>
#include <set>

using namespace penumbra;

namespace
{
using Names = std::vector<std::string>;

std::string GetValue(const LightingRequirements& requirements, const std::string& name)
{
  for (const RequirementEntry& entry : requirements.GetEntries())
  {
    if (entry.Name == name)
    {
      return entry.Value;
    }
  }
  return "there is no entry of this name";
}

LightingRequirements MakeEverything()
{
  LightingRequirements everything;
  everything.Optics = OpticalModel::SingleScattering;
  everything.Diffuse = everything.Specular = true;
  everything.GradientTexture = everything.NoiseFading = everything.PreIntegrated = true;
  everything.HalvedSteps = true;
  everything.EmptySpaceSkipping = true;
  everything.TwoSidedLighting = everything.Attenuation = true;
  everything.GradientOpacity = everything.Mask = true;
  everything.ClippingPlanes = 6;
  everything.Cropping = CroppingKind::Regions;
  everything.Lights = { { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } } };
  return everything;
}
}

TEST_CASE("A bare volume leaves out all but its opacity")
{
  CHECK(LightingRequirements().GetLeftOut() ==
    Names{ "pre-integration", "halved steps", "empty-space skipping", "gradient opacity",
      "clipping planes", "cropping", "mask", "shading", "gradient", "gradient texture",
      "reflection model", "diffuse term", "specular term", "fresnel term", "preferred direction",
      "environment maps", "noise fading", "two-sided lighting", "directional lights",
      "point lights", "spot lights", "attenuation", "soft shadows", "hard shadows",
      "shadow technique", "shadow rays" });
}

TEST_CASE("A scene that needs everything leaves out only what belongs to other reflection models")
{
  const LightingRequirements everything = MakeEverything();
  CHECK(
    everything.GetLeftOut() == Names{ "fresnel term", "preferred direction", "environment maps" });
  CHECK(GetValue(everything, "directional lights") == "6");
  CHECK(GetValue(everything, "point lights") == "15");
  CHECK(GetValue(everything, "spot lights") == "24");
  CHECK(GetValue(everything, "soft shadows") == "15");
  CHECK(GetValue(everything, "hard shadows") == "18");
  CHECK(GetValue(everything, "clipping planes") == "6");
  CHECK(GetValue(everything, "cropping") == "regions");
  CHECK(GetValue(everything, "opacity") == "table");
  CHECK(GetValue(everything, "shadow technique") == "rays");
}

TEST_CASE("What is left out follows from what is there")
{
  LightingRequirements unshadowed = MakeEverything();
  unshadowed.Lights = { { { 1, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } } };
  CHECK(unshadowed.GetLeftOut() ==
    Names{ "fresnel term", "preferred direction", "environment maps", "point lights", "spot lights",
      "attenuation", "soft shadows", "hard shadows", "shadow technique", "shadow rays" });

  LightingRequirements ambientOnly;
  ambientOnly.Optics = OpticalModel::SingleScattering;
  ambientOnly.GradientOpacity = true;
  const Names leftOut = ambientOnly.GetLeftOut();
  CHECK(std::count(leftOut.begin(), leftOut.end(), "shading") == 0);
  CHECK(std::count(leftOut.begin(), leftOut.end(), "gradient") == 0);
  CHECK(std::count(leftOut.begin(), leftOut.end(), "reflection model") == 1);
}

TEST_CASE("A reflection model tells its own needs")
{
  LightingRequirements needs = MakeEverything();
  needs.Reflection = ReflectionModel::CookTorrance;
  CHECK(needs.GetLeftOut() == Names{ "preferred direction", "environment maps" });
  CHECK(GetValue(needs, "reflection model") == "cook-torrance");
  needs.Specular = false;
  CHECK(GetValue(needs, "fresnel term") == "no");
  needs.Reflection = ReflectionModel::WardAnisotropic;
  CHECK(needs.GetLeftOut() == Names{ "specular term", "fresnel term", "environment maps" });

  LightingRequirements mirror;
  mirror.Optics = OpticalModel::SingleScattering;
  mirror.Reflection = ReflectionModel::ReflectionMap;
  CHECK_FALSE(mirror.NeedsGradient());
  mirror.Diffuse = true;
  CHECK(GetValue(mirror, "environment maps") == "1");
  mirror.Specular = true;
  CHECK(GetValue(mirror, "environment maps") == "2");
  CHECK(GetValue(mirror, "gradient") == "central differences");
}

TEST_CASE("Absorption alone leaves out the colours")
{
  LightingRequirements needs;
  CHECK(GetValue(needs, "optical model") == "absorption-emission");
  needs.Optics = OpticalModel::Absorption;
  CHECK(needs.GetLeftOut().at(3) == "colour");
  needs.Optics = OpticalModel::Emission;
  CHECK(GetValue(needs, "colour") == "yes");
}

TEST_CASE("Entries have one name each, and what is left out has the value of nothing")
{
  for (const LightingRequirements& requirements : { LightingRequirements(), MakeEverything() })
  {
    std::set<std::string> names;
    for (const RequirementEntry& entry : requirements.GetEntries())
    {
      CHECK(names.insert(entry.Name).second);
      const bool nothing = entry.Value == "no" || entry.Value == "none" || entry.Value == "0";
      CHECK(entry.Needed != nothing);
    }
  }
}
