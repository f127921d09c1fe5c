/**
 * @file    ShaderSource.h
 * @brief   the GLSL that a scene's requirements select
 */

#ifndef ShaderSource_h
#define ShaderSource_h

#include "LightingRequirements.h"
#include "PenumbraRenderingModule.h" // For export macro

#include <string>

namespace penumbra
{

/// The vertex shader of the box that stands for the volume.
PENUMBRARENDERING_EXPORT std::string GetVertexShaderSource();

/// The fragment shader for these requirements; continued: a draw that goes on with what earlier
/// draws of the same picture gathered.
PENUMBRARENDERING_EXPORT std::string GetFragmentShaderSource(
  const LightingRequirements& requirements, bool continued);

/// The fragment shader that puts a gathered picture over the viewport.
PENUMBRARENDERING_EXPORT std::string GetCompositeShaderSource();

}

#endif
