#include "SpeedGrid.h"

namespace penumbra
{
namespace
{
// As often as its turn comes.
constexpr int ManyRounds = 100;
const std::vector<std::string> UnlitSettings = { "shade=false",
  "opticalModel=absorption-emission" };
const std::vector<std::string> StockUnlitSettings = { "renderer=vtk", "shade=false",
  "opticalModel=absorption-emission" };

std::vector<std::string> Lit(const std::vector<std::string>& more)
{
  std::vector<std::string> settings = { "shade=true", "opticalModel=single-scattering" };
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

std::vector<std::string> Shadowed(const std::string& shadow, const std::string& technique)
{
  return Lit({ "lights.0.shadow=" + shadow, "shadows.technique=" + technique });
}

// A shadow is held against rays with half the shadow step.
SpeedVariant ShadowVariant(const std::string& technique, const std::string& shadow)
{
  SpeedVariant variant;
  variant.Name = technique + (shadow == "hard" ? ", hard" : "");
  variant.Request.Settings = Shadowed(shadow, technique);
  variant.Truth = SpeedRequest{ Shadowed(shadow, "rays"), 1.0, 0.5 };
  // Rays keep nothing that an edit could change.
  variant.HasEdits = technique != "rays";
  return variant;
}

// Shadows cached in more or fewer texels than the volume has voxels.
void AddResolutions(std::vector<SpeedVariant>& variants)
{
  const std::pair<const char*, const char*> resolutions[] = { { "1/4", "0.25" }, { "1/2", "0.5" },
    { "2", "2" } };
  const std::pair<const char*, const char*> shadows[] = { { "volume", "soft" },
    { "deep-map", "soft" }, { "opacity-map", "soft" }, { "map", "hard" } };
  for (const auto& [technique, shadow] : shadows)
  {
    for (const auto& [name, value] : resolutions)
    {
      SpeedVariant variant = ShadowVariant(technique, shadow);
      variant.Name += std::string(" x ") + name;
      variant.Request.Settings.push_back(std::string("shadows.resolution=") + value);
      variants.push_back(variant);
    }
  }
}

// How right a shadow is is told of one light.
void ForgetTruths(std::vector<SpeedVariant>& variants)
{
  for (SpeedVariant& variant : variants)
  {
    variant.Truth.reset();
  }
}

// What an edit costs is told of one soft shadow, as bounds are stated for.
void ForgetEdits(const SpeedCell& cell, std::vector<SpeedVariant>& variants)
{
  for (SpeedVariant& variant : variants)
  {
    const bool isHard = variant.Name.find("hard") != std::string::npos;
    variant.HasEdits = variant.HasEdits && cell.IsPlain() && !isHard;
  }
}

// The picture of an unlit scene is the stock mapper's where steps are short.
SpeedVariant UnlitAtQuarterVoxel()
{
  constexpr double quarter = 0.25;
  return { "unlit, 1/4 voxel", { UnlitSettings, quarter },
    SpeedRequest{ StockUnlitSettings, quarter }, false, 1 };
}

void AddImages(
  const SpeedScene& scene, const std::vector<int>& images, std::vector<SpeedCell>& grid)
{
  for (const int image : images)
  {
    grid.push_back({ scene, 0, image, 1 });
  }
}

void AddAxes(const SpeedScene& scene, std::vector<SpeedCell>& grid)
{
  for (const int edge : { 64, 128, 256 })
  {
    grid.push_back({ scene, edge, 512, 1 });
  }
  for (const int lights : { 2, 8 })
  {
    grid.push_back({ scene, 0, 512, lights });
  }
  AddImages(scene, { 128, 256 }, grid);
}

void AddProduct(const SpeedScene& scene, std::vector<SpeedCell>& grid)
{
  for (const int edge : { 0, 64, 128, 256, 512 })
  {
    for (const int lights : { 1, 2, 4, 8 })
    {
      const bool isThere = edge == 0 && (lights == 1 || lights == 4);
      if (!isThere)
      {
        grid.push_back({ scene, edge, 512, lights });
      }
    }
  }
  AddImages(scene, { 128, 256, 1024 }, grid);
}
}

//------------------------------------------------------------------------------
const char* const StockUnlit = "vtk, unlit";
const char* const AutoOfOneLight = "auto, one light";

//------------------------------------------------------------------------------
std::vector<SpeedVariant> GetSpeedVariants(const SpeedCell& cell, bool full)
{
  // Of scenes without axes bounds alone are asked with several lights.
  const bool isWhole = full || cell.Lights == 1 || cell.Scene.HasAxes;
  std::vector<SpeedVariant> variants = { { StockUnlit, { StockUnlitSettings }, {}, false,
    ManyRounds } };
  if (isWhole)
  {
    variants.push_back({ "vtk, lit", { Lit({ "renderer=vtk" }) }, {} });
  }
  variants.push_back({ "unlit", { UnlitSettings }, {} });
  variants.push_back({ "lit", { Lit({ "lights.0.shadow=none" }) }, {} });
  if (isWhole)
  {
    for (const char* technique : { "rays", "volume", "deep-map", "opacity-map" })
    {
      variants.push_back(ShadowVariant(technique, "soft"));
    }
  }
  variants.push_back(ShadowVariant("auto", "soft"));
  if (cell.IsPlainOfFourLights())
  {
    variants.back().Rounds = cell.Scene.HasBounds ? RoundsOfFourLights : UsualRounds;
    variants.push_back(variants.back());
    variants.back().Name = AutoOfOneLight;
    variants.back().Request.HasOneLight = true;
  }
  if (cell.Lights > 1)
  {
    ForgetTruths(variants);
  }
  if (cell.IsPlain())
  {
    for (const char* technique : { "rays", "volume", "map", "deep-map", "opacity-map" })
    {
      variants.push_back(ShadowVariant(technique, "hard"));
    }
    variants.push_back(UnlitAtQuarterVoxel());
  }
  if (full && cell.Lights == 1 && cell.Image == 512)
  {
    AddResolutions(variants);
  }
  if (!full)
  {
    ForgetEdits(cell, variants);
  }
  return variants;
}

//------------------------------------------------------------------------------
std::vector<SpeedCell> MakeSpeedGrid(const std::vector<SpeedScene>& scenes, bool full)
{
  std::vector<SpeedCell> grid;
  for (const SpeedScene& scene : scenes)
  {
    grid.push_back({ scene });
  }
  for (const SpeedScene& scene : scenes)
  {
    grid.push_back({ scene, 0, 512, 4 });
  }
  for (const SpeedScene& scene : scenes)
  {
    if (full)
    {
      AddProduct(scene, grid);
    }
    else if (scene.HasAxes)
    {
      AddAxes(scene, grid);
    }
  }
  return grid;
}

}
