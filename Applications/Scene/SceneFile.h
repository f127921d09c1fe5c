/**
 * @file    SceneFile.h
 * @brief   scenes from files, and settings that change single keys of them
 */

#ifndef SceneFile_h
#define SceneFile_h

#include "SceneDescription.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

constexpr int MostJsonLevels = 100;

/// Whether a file is a scene, going by its name; anything else is a volume.
bool IsSceneFile(const std::filesystem::path& file);

/**
 * JSON of which no object has a key twice, with at most MostJsonLevels levels.
 * @throw InputError where it is not, with line and column where it is not JSON.
 */
nlohmann::json ParseJson(const std::string& text);

/**
 * The scene in a scene file, or a volume with the defaults for all else, after the settings (see
 * ApplySetting) were applied in their order. Paths in settings are relative to where paths in the
 * scene are: to the scene file's folder, or to the current folder for a volume.
 * @throw InputError where the file cannot be read or the scene is not valid. The volume itself is
 * not opened.
 */
SceneDescription LoadScene(
  const std::filesystem::path& file, const std::vector<std::string>& settings);

}

#endif
