#include "SceneFile.h"

#include "InputError.h"
#include "Preset.h"
#include "SceneParser.h"
#include "SceneSettings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

namespace penumbra
{
namespace
{
// Refuses keys that stand twice in one object, of which JSON readers silently take the last, and
// more levels than what follows values by recursion can take.
class StructureCheck
{
public:
  bool operator()(int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed)
  {
    switch (event)
    {
      case nlohmann::json::parse_event_t::array_start:
        RefuseDeeper(depth);
        break;
      case nlohmann::json::parse_event_t::object_start:
        RefuseDeeper(depth);
        this->KeysOfOpenObjects.emplace_back();
        break;
      case nlohmann::json::parse_event_t::key:
        if (!this->KeysOfOpenObjects.back().insert(parsed.get<std::string>()).second)
        {
          throw InputError("the key " + parsed.dump() + " stands twice in one object");
        }
        break;
      case nlohmann::json::parse_event_t::object_end:
        this->KeysOfOpenObjects.pop_back();
        break;
      default:
        break;
    }
    return true;
  }

private:
  static void RefuseDeeper(int levels)
  {
    if (levels >= MostJsonLevels)
    {
      throw InputError("arrays and objects are nested more than " + std::to_string(MostJsonLevels) +
        " levels deep; no scene needs as many");
    }
  }

  std::vector<std::set<std::string>> KeysOfOpenObjects;
};

// nlohmann's message without the name of its exception class.
std::string ReasonOf(const nlohmann::json::exception& error)
{
  const std::string text = error.what();
  const auto end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}

//------------------------------------------------------------------------------
std::string ReadJsonFile(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
  {
    throw InputError("there is no such file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored))
  {
    throw InputError("cannot be read; a file of JSON is needed");
  }
  std::string text{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (stream.bad())
  {
    throw InputError("cannot be read to its end");
  }
  return text;
}

namespace
{
nlohmann::json ReadSceneJson(const std::filesystem::path& file)
{
  if (IsSceneFile(file))
  {
    return ParseJson(ReadJsonFile(file));
  }
  return { { "volume", { { "file", std::filesystem::absolute(file).u8string() } } } };
}

// What the scene says itself stays.
void AddAppearance(
  nlohmann::json& scene, const std::string& name, const std::filesystem::path& folder)
{
  if (!scene.is_object())
  {
    return; // which the parser refuses
  }
  const Preset preset = FindPreset(name, folder);
  if (!scene.contains("transferFunction"))
  {
    scene["transferFunction"] = { { "preset", name } };
  }
  if (preset.Material && !scene.contains("material"))
  {
    scene["material"] = *preset.Material;
  }
  if (preset.Lights && !scene.contains("lights"))
  {
    scene["lights"] = *preset.Lights;
  }
}
}

//------------------------------------------------------------------------------
bool IsSceneFile(const std::filesystem::path& file)
{
  std::string extension = file.extension().u8string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".json";
}

//------------------------------------------------------------------------------
nlohmann::json ParseJson(const std::string& text)
{
  try
  {
    StructureCheck check;
    return nlohmann::json::parse(text, std::ref(check));
  }
  catch (const nlohmann::json::exception& error)
  {
    throw InputError("not valid JSON: " + ReasonOf(error));
  }
}

//------------------------------------------------------------------------------
SceneSource::SceneSource(const std::filesystem::path& file,
  const std::vector<std::string>& settings, const std::string& preset)
  : File(file)
  , Folder(IsSceneFile(file) ? std::filesystem::absolute(file).parent_path()
                             : std::filesystem::current_path())
  , Settings(settings)
  , Preset(preset)
  , IsVolume(!IsSceneFile(file))
{
  try
  {
    this->Scene = std::make_unique<const nlohmann::json>(ReadSceneJson(file));
  }
  catch (const InputError& error)
  {
    throw InputError(file.u8string() + ": " + error.what());
  }
}

//------------------------------------------------------------------------------
SceneSource::~SceneSource() = default;

//------------------------------------------------------------------------------
SceneDescription SceneSource::Describe(const std::string& preset) const
{
  try
  {
    nlohmann::json scene = *this->Scene;
    if (!preset.empty())
    {
      AddAppearance(scene, preset, this->Folder);
    }
    for (const std::string& setting : this->Settings)
    {
      ApplySetting(scene, setting);
    }
    return ParseScene(scene, this->Folder);
  }
  catch (const InputError& error)
  {
    throw InputError(this->File.u8string() + ": " + error.what());
  }
}

//------------------------------------------------------------------------------
SceneDescription LoadScene(
  const std::filesystem::path& file, const std::vector<std::string>& settings)
{
  return SceneSource(file, settings).Describe("");
}

}
