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
  everything.Shade = everything.Diffuse = everything.Specular = true;
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
    Names{ "gradient opacity", "clipping planes", "cropping", "mask", "shading", "gradient",
      "reflection model", "diffuse term", "specular term", "two-sided lighting",
      "directional lights", "point lights", "spot lights", "attenuation", "soft shadows",
      "hard shadows", "shadow technique" });
}

TEST_CASE("A scene that needs everything leaves out nothing")
{
  const LightingRequirements everything = MakeEverything();
  CHECK(everything.GetLeftOut().empty());
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
    Names{ "point lights", "spot lights", "attenuation", "soft shadows", "hard shadows",
      "shadow technique" });

  LightingRequirements ambientOnly;
  ambientOnly.Shade = ambientOnly.GradientOpacity = true;
  const Names leftOut = ambientOnly.GetLeftOut();
  CHECK(std::count(leftOut.begin(), leftOut.end(), "shading") == 0);
  CHECK(std::count(leftOut.begin(), leftOut.end(), "gradient") == 0);
  CHECK(std::count(leftOut.begin(), leftOut.end(), "reflection model") == 1);
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
