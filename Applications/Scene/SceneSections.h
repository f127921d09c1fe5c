/**
 * @file    SceneSections.h
 * @brief   the parser's parts, one for each section of a scene file
 */

#ifndef SceneSections_h
#define SceneSections_h

#include "JsonObject.h"
#include "SceneDescription.h"

namespace penumbra
{

VolumeDescription ParseVolume(const nlohmann::json& value, const std::filesystem::path& folder);
/// Presets' files are relative to `folder`.
TransferFunctionDescription ParseTransferFunction(
  const nlohmann::json& value, const std::filesystem::path& folder);
/// Images are relative to `folder`.
MaterialDescription ParseMaterial(const nlohmann::json& value, const std::filesystem::path& folder);
LightDescription ParseLight(const nlohmann::json& value, const std::string& path);
CameraDescription ParseCamera(const nlohmann::json& value);

}

#endif
