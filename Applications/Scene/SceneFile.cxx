#include "SceneFile.h"

#include "InputError.h"
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

std::string ReadText(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
  {
    throw InputError("there is no such file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored))
  {
    throw InputError("cannot be read; a scene is a file of JSON");
  }
  std::string text{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (stream.bad())
  {
    throw InputError("cannot be read to its end");
  }
  return text;
}

nlohmann::json ReadSceneJson(const std::filesystem::path& file)
{
  if (IsSceneFile(file))
  {
    return ParseJson(ReadText(file));
  }
  return { { "volume", { { "file", std::filesystem::absolute(file).u8string() } } } };
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
SceneDescription LoadScene(
  const std::filesystem::path& file, const std::vector<std::string>& settings)
{
  try
  {
    nlohmann::json scene = ReadSceneJson(file);
    for (const std::string& setting : settings)
    {
      ApplySetting(scene, setting);
    }
    const auto folder = IsSceneFile(file) ? std::filesystem::absolute(file).parent_path()
                                          : std::filesystem::current_path();
    return ParseScene(scene, folder);
  }
  catch (const InputError& error)
  {
    throw InputError(file.u8string() + ": " + error.what());
  }
}

}
