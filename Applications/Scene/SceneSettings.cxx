#include "SceneSettings.h"

#include "InputError.h"
#include "JsonObject.h"
#include "SceneFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <vector>

namespace penumbra
{
namespace
{
using Path = std::vector<std::string>;

// Defaults of the arrays that a path can enter, by the path with "*" for an index. They are those
// of SceneDescription.
const nlohmann::json& DefaultArrays()
{
  static const nlohmann::json arrays = nlohmann::json::parse(R"({
    "volume.spacing": [1, 1, 1],
    "volume.origin": [0, 0, 0],
    "volume.direction": [1, 0, 0, 0, 1, 0, 0, 0, 1],
    "volume.transform": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    "material.preferredDirection": [1, 0, 0],
    "material.indexOfRefraction": [1.5, 1.5, 1.5],
    "lights": [{ "type": "headlight" }],
    "lights.*.position": [0, 0, 0],
    "lights.*.direction": [0, 0, -1],
    "lights.*.ambient": [1, 1, 1],
    "lights.*.diffuse": [1, 1, 1],
    "lights.*.specular": [1, 1, 1],
    "lights.*.attenuation": [1, 0, 0],
    "clippingPlanes.*.origin": [0, 0, 0],
    "clippingPlanes.*.normal": [1, 0, 0],
    "image.size": [512, 512],
    "image.background": [0, 0, 0]
  })");
  return arrays;
}

bool IsIndex(const std::string& part)
{
  constexpr std::size_t mostDigits = 6;
  return !part.empty() && part.size() <= mostDigits &&
    std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

Path SplitPath(const std::string& text)
{
  Path path;
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find('.', begin), text.size());
    path.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return path;
}

std::string JoinPath(const Path& path, std::size_t length, bool generalizeIndices = false)
{
  std::string text;
  for (std::size_t i = 0; i < length; ++i)
  {
    text += (i == 0 ? "" : ".") + (generalizeIndices && IsIndex(path[i]) ? "*" : path[i]);
  }
  return text;
}

nlohmann::json ParseSettingValue(const std::string& text)
{
  // A word never begins like this: what does is JSON with a mistake in it.
  const bool looksLikeJson =
    !text.empty() && std::string("[{\"").find(text[0]) != std::string::npos;
  if (looksLikeJson || nlohmann::json::accept(text))
  {
    return ParseJson(text);
  }
  return text;
}

nlohmann::json& EnterArray(nlohmann::json& array, const Path& path, std::size_t depth)
{
  const std::size_t size = array.size();
  const std::size_t index = IsIndex(path[depth]) ? std::stoul(path[depth]) : size + 1;
  if (index > size)
  {
    throw InputError(JoinPath(path, depth + 1) + " does not exist; " + JoinPath(path, depth) +
      " takes an index from 0 to " + std::to_string(size) + ", where the last adds an entry");
  }
  if (index == size)
  {
    array.push_back(nullptr);
  }
  return array[index];
}

// The value that path[depth] names within `parent`, made where it is absent.
nlohmann::json& Enter(nlohmann::json& parent, const Path& path, std::size_t depth)
{
  if (parent.is_null())
  {
    parent = IsIndex(path[depth]) ? nlohmann::json::array() : nlohmann::json::object();
    const auto known = DefaultArrays().find(JoinPath(path, depth, true));
    if (parent.is_array() && known != DefaultArrays().end())
    {
      parent = *known;
    }
  }
  if (parent.is_array())
  {
    return EnterArray(parent, path, depth);
  }
  if (!parent.is_object())
  {
    throw InputError(JoinPath(path, depth + 1) + " does not exist; " + JoinPath(path, depth) +
      " is " + ValueInWords(parent));
  }
  return parent[path[depth]];
}
}

//------------------------------------------------------------------------------
void ApplySetting(nlohmann::json& scene, const std::string& setting)
{
  if (!IsUtf8(setting))
  {
    throw InputError("the setting " + ValueInWords(setting) + " is not valid UTF-8");
  }
  const auto equals = setting.find('=');
  const Path path = SplitPath(setting.substr(0, equals));
  if (equals == std::string::npos || std::count(path.begin(), path.end(), "") > 0)
  {
    throw InputError("the setting " + ValueInWords(setting) +
      " is not of the form key.path=value, such as image.size=[256,256]");
  }
  if (path.size() > static_cast<std::size_t>(MostJsonLevels))
  {
    throw InputError("the setting " + ValueInWords(setting) + " names a key more than " +
      std::to_string(MostJsonLevels) + " levels deep; no scene needs as many");
  }
  if (!scene.is_object())
  {
    return; // which ParseScene refuses
  }
  try
  {
    nlohmann::json* target = &scene;
    for (std::size_t depth = 0; depth < path.size(); ++depth)
    {
      target = &Enter(*target, path, depth);
    }
    *target = ParseSettingValue(setting.substr(equals + 1));
  }
  catch (const InputError& error)
  {
    throw InputError("the setting " + ValueInWords(setting) + ": " + error.what());
  }
}

}
