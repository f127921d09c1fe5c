/**
 * @file    ResolvedScene.h
 * @brief   a scene of a volume, with defaults for all that its text leaves out
 */

#ifndef ResolvedScene_h
#define ResolvedScene_h

#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"

#include <nlohmann/json.hpp>

#include <string>

namespace penumbra
{

/// members: what follows the volume in the scene, each with a comma before it.
inline SceneDescription Resolve(const std::string& members, vtkImageData* volume)
{
  SceneDescription scene =
    ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd" })" + members + "}"), "");
  ResolveScene(scene, volume);
  return scene;
}

}

#endif
