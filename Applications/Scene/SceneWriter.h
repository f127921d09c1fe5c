/**
 * @file    SceneWriter.h
 * @brief   a resolved scene back to JSON
 */

#ifndef SceneWriter_h
#define SceneWriter_h

#include "SceneDescription.h"

#include <string>

namespace penumbra
{

/**
 * The whole scene with every default and choice spelled out, as the text of a scene file for
 * `folder`: files are named from there. `scene` must be resolved. Parsing the text gives the same
 * scene to the last bit.
 * @throw InputError where a file has a name that is not UTF-8.
 */
std::string WriteScene(const SceneDescription& scene, const std::filesystem::path& folder);

}

#endif
