/**
 * @file    SceneParser.h
 * @brief   the JSON of a scene to a SceneDescription
 */

#ifndef SceneParser_h
#define SceneParser_h

#include "SceneDescription.h"

#include <nlohmann/json_fwd.hpp>

namespace penumbra
{

/**
 * The scene that `scene` describes; relative paths in it are relative to `folder`.
 * @throw InputError at the first unknown key, wrong type or impossible value, and at keys and
 * values that are part of the format but not built yet.
 */
SceneDescription ParseScene(const nlohmann::json& scene, const std::filesystem::path& folder);

}

#endif
