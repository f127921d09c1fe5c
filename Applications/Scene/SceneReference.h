/**
 * @file    SceneReference.h
 * @brief   a described scene as the reference integrator takes it
 */

#ifndef SceneReference_h
#define SceneReference_h

#include "ReferenceScene.h"
#include "SceneDescription.h"

namespace penumbra
{

class SceneRendering;
struct SceneVoxels;

/// The scene as the rendering has it now: its volume, property, lights and camera, which may have
/// changed since they were described.
ReferenceScene MakeReferenceScene(
  const SceneDescription& scene, const SceneVoxels& voxels, SceneRendering& rendering);

}

#endif
