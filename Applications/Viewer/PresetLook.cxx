#include "PresetLook.h"

#include "AppearancePreset.h"
#include "BodyRegion.h"
#include "Preset.h"
#include "SceneFile.h"
#include "SceneSections.h"
#include "SceneWriter.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>

#include <algorithm>

namespace penumbra
{
namespace
{
void ApplyLook(const Preset& preset, const std::filesystem::path& folder, vtkImageData* image,
  const VolumeStatistics& statistics, SceneDescription& scene)
{
  scene.TransferFunction = ScaleToVolume(preset, image, statistics);
  scene.TransferFunction.OpacityUnitDistance =
    scene.TransferFunction.OpacityUnitDistance.value_or(1.0);
  scene.Material =
    preset.Material ? ParseMaterial(*preset.Material, folder) : MaterialDescription();
}
}

//------------------------------------------------------------------------------
std::vector<PresetName> ListPresets(const std::string& modality)
{
  std::vector<PresetName> names;
  for (const AppearancePreset& document : GetAppearancePresets())
  {
    const Preset preset = FindPreset(document.Name, {});
    const auto& suits = preset.Modalities;
    if (modality.empty() || suits.empty() ||
      std::find(suits.begin(), suits.end(), modality) != suits.end())
    {
      names.push_back({ preset.Name, preset.Description });
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void ApplyPreset(const std::string& name, const std::filesystem::path& folder, vtkImageData* image,
  const VolumeStatistics& statistics, SceneDescription& scene)
{
  const Preset preset = FindPreset(name, folder);
  ApplyLook(preset, folder, image, statistics, scene);
  scene.Volume.Cropping.reset();
  if (preset.CropMargin)
  {
    scene.Volume.Cropping = FindBodyRegion(image, *preset.CropMargin);
  }
}

//------------------------------------------------------------------------------
std::string LookOf(const SceneDescription& scene)
{
  const nlohmann::json written = ParseJson(WriteScene(scene, scene.Volume.File.parent_path()));
  return written["transferFunction"].dump() + written["material"].dump();
}

//------------------------------------------------------------------------------
std::string LookOfPreset(const std::string& name, vtkImageData* image,
  const VolumeStatistics& statistics, SceneDescription scene)
{
  ApplyLook(FindPreset(name, {}), {}, image, statistics, scene);
  return LookOf(scene);
}

//------------------------------------------------------------------------------
std::string WritePreset(const SceneDescription& scene, const std::string& name)
{
  const nlohmann::json written = ParseJson(WriteScene(scene, scene.Volume.File.parent_path()));
  nlohmann::ordered_json preset = { { "name", name }, { "description", "" },
    { "modalities", nlohmann::json::array() } };
  preset["transferFunction"] = written["transferFunction"];
  preset["transferFunction"]["scale"] = "scalars";
  preset["material"] = written["material"];
  return preset.dump(2) + "\n";
}

//------------------------------------------------------------------------------
void ShiftAndStretch(
  TransferFunctionDescription& function, double shift, double factor, double center)
{
  const auto move = [=](auto& points)
  {
    for (auto& point : points)
    {
      point[0] = center + (point[0] - center) * factor + shift;
    }
  };
  move(*function.Opacity);
  move(*function.Color);
}

}
