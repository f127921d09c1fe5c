/**
 * @file    SceneSettings.h
 * @brief   single keys of a scene, set on the command line
 */

#ifndef SceneSettings_h
#define SceneSettings_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace penumbra
{

/**
 * Overrides or adds one key of a scene. `setting` is `key.path=value`; parts of the path that are
 * whole numbers are array indices, of which one past the end adds an entry. The value is JSON, or
 * else a bare word. Where the path enters an array that is absent, the array's default is what
 * changes: `lights.0.shadow=soft` lets the default headlight cast shadows.
 * @throw InputError where `setting` has no such form or the path does not fit the scene. Whether
 * the key exists in the format and takes the value is for ParseScene to say.
 */
void ApplySetting(nlohmann::json& scene, const std::string& setting);

}

#endif
