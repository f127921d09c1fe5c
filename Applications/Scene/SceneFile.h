/**
 * @file    SceneFile.h
 * @brief   scenes from files, and settings that change single keys of them
 */

#ifndef SceneFile_h
#define SceneFile_h

#include "SceneDescription.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <memory>
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
 * @throw InputError where the file cannot be read.
 */
std::string ReadJsonFile(const std::filesystem::path& file);

/**
 * A scene before it is parsed: what a scene file says, or a volume alone, and settings (see
 * ApplySetting) that change it.
 */
class SceneSource
{
public:
  /**
   * Paths in settings are relative to where paths in the scene are: to the scene file's folder, or
   * to the current folder for a volume. `preset` gives what the scene does not say of its
   * appearance; it may be empty.
   * @throw InputError where the file cannot be read.
   */
  SceneSource(const std::filesystem::path& file, const std::vector<std::string>& settings,
    const std::string& preset = "");
  ~SceneSource();

  /**
   * The scene with this preset's appearance, or without any where it is empty, where neither the
   * file nor the settings say otherwise.
   * @throw InputError where the scene is not valid. The volume itself is not opened.
   */
  SceneDescription Describe(const std::string& preset) const;

  /// Whether the appearance is for the volume's own values to choose.
  bool IsPresetOpen() const { return this->IsVolume && this->Preset.empty(); }

  /// The preset asked for, or empty.
  const std::string& GetPreset() const { return this->Preset; }

  /// Whether it is a volume without a scene.
  bool IsBareVolume() const { return this->IsVolume; }

private:
  std::filesystem::path File;
  std::filesystem::path Folder;
  std::vector<std::string> Settings;
  std::string Preset;
  bool IsVolume;
  std::unique_ptr<const nlohmann::json> Scene;
};

/**
 * The scene in a scene file, or a volume with the defaults for all else, after the settings.
 * @throw InputError as SceneSource does.
 */
SceneDescription LoadScene(
  const std::filesystem::path& file, const std::vector<std::string>& settings);

}

#endif
