#include "Preset.h"

#include "AppearancePreset.h"
#include "InputError.h"
#include "JsonObject.h"
#include "SceneFile.h"
#include "SceneSections.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace penumbra
{
namespace
{
std::vector<std::string> ReadTexts(JsonObject& object, const std::string& key)
{
  std::vector<std::string> texts;
  for (const auto& [value, path] : object.ReadArray(key))
  {
    if (!value->is_string())
    {
      RefuseValue(path, *value, "a text");
    }
    texts.push_back(value->get<std::string>());
  }
  return texts;
}

std::shared_ptr<const nlohmann::json> CopyOf(JsonObject& object, const std::string& key)
{
  const nlohmann::json* value = object.Find(key);
  return value ? std::make_shared<const nlohmann::json>(*value) : nullptr;
}

void ReadTransferFunction(JsonObject& object, Preset& preset)
{
  const nlohmann::json* value = object.Find("transferFunction");
  if (!value || !value->is_object())
  {
    throw InputError("transferFunction is missing; a preset needs it");
  }
  nlohmann::json function = *value;
  JsonObject reader(*value, "transferFunction");
  reader.ReadChoice<PresetScale>("scale", preset.Scale,
    { { "scalars", PresetScale::Scalars }, { "percentiles", PresetScale::Percentiles },
      { "percentiles-of-all", PresetScale::AllPercentiles },
      { "threshold", PresetScale::Threshold } });
  function.erase("scale");
  preset.TransferFunction = ParseTransferFunction(function, {});
  if (preset.TransferFunction.FromPreset)
  {
    throw InputError("transferFunction.preset stands in a preset; it needs points of its own");
  }
  if (!preset.TransferFunction.Opacity || !preset.TransferFunction.Color)
  {
    throw InputError("transferFunction has no opacity or no color; a preset needs both");
  }
}

Preset ParsePreset(const nlohmann::json& document)
{
  Preset preset;
  JsonObject object(document, "");
  object.Read("name", preset.Name);
  object.Read("description", preset.Description);
  preset.Modalities = ReadTexts(object, "modalities");
  object.Read("cropMargin", preset.CropMargin, AnyNumber);
  ReadTransferFunction(object, preset);
  preset.Material = CopyOf(object, "material");
  preset.Lights = CopyOf(object, "lights");
  object.RefuseUnknownKeys();
  if (preset.Material)
  {
    ParseMaterial(*preset.Material, {});
  }
  for (const auto& [value, path] : object.ReadArray("lights"))
  {
    ParseLight(*value, path);
  }
  return preset;
}

std::string NamesOfPresets()
{
  std::string names;
  for (const AppearancePreset& preset : GetAppearancePresets())
  {
    names += (names.empty() ? "" : ", ") + preset.Name;
  }
  return names;
}
}

//------------------------------------------------------------------------------
Preset FindPreset(const std::string& name, const std::filesystem::path& folder)
{
  const auto& presets = GetAppearancePresets();
  const auto found = std::find_if(presets.begin(), presets.end(),
    [&name](const AppearancePreset& preset) { return preset.Name == name; });
  if (found != presets.end())
  {
    return ParsePreset(ParseJson(found->Document));
  }
  const std::filesystem::path file = folder / std::filesystem::u8path(name);
  if (!IsSceneFile(file))
  {
    throw InputError("there is no preset \"" + name + "\"; accepted: " + NamesOfPresets() +
      ", or the name of a preset's file, which ends in .json");
  }
  try
  {
    Preset preset = ParsePreset(ParseJson(ReadJsonFile(file)));
    preset.Name = name;
    return preset;
  }
  catch (const InputError& error)
  {
    throw InputError("preset " + file.u8string() + ": " + error.what());
  }
}

//------------------------------------------------------------------------------
std::string DescribePresets()
{
  constexpr int column = 16;
  std::ostringstream text;
  for (const AppearancePreset& preset : GetAppearancePresets())
  {
    text << std::left << std::setw(column) << preset.Name
         << ParsePreset(ParseJson(preset.Document)).Description << "\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
nlohmann::json FindMaterial(const std::string& name, const std::string& path)
{
  const nlohmann::json materials = ParseJson(GetNamedMaterials());
  const auto found = materials.find(name);
  if (found == materials.end())
  {
    std::string names;
    for (const auto& material : materials.items())
    {
      names += (names.empty() ? "" : ", ") + material.key();
    }
    RefuseValue(path, name, names);
  }
  nlohmann::json material = *found;
  material.erase("description");
  return material;
}

}
