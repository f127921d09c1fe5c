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

/// The geometry shader that leaves out where nothing is seen; empty where no empty space is known.
PENUMBRARENDERING_EXPORT std::string GetGeometryShaderSource(
  const LightingRequirements& requirements);

/// The fragment shader for these requirements; continued: a draw that goes on with what earlier
/// draws of the same picture gathered.
PENUMBRARENDERING_EXPORT std::string GetFragmentShaderSource(
  const LightingRequirements& requirements, bool continued);

/// What of the requirements concerns how matter absorbs, with all else left out.
PENUMBRARENDERING_EXPORT LightingRequirements GetMatterRequirements(
  const LightingRequirements& requirements);

/// The fragment shader that computes one light's visibility over a slice of the shadow volume, with
/// the very GLSL of a picture's shadow rays.
PENUMBRARENDERING_EXPORT std::string GetShadowVolumeSource(
  const LightingRequirements& requirements);

/// The fragment shader that makes one light's shadow map or deep shadow map.
PENUMBRARENDERING_EXPORT std::string GetShadowMapSource(const LightingRequirements& requirements);

/// The fragment shader that makes some layers of one light's opacity shadow map.
PENUMBRARENDERING_EXPORT std::string GetOpacityMapSource(const LightingRequirements& requirements);

/// The fragment shader that puts a gathered picture over the viewport.
PENUMBRARENDERING_EXPORT std::string GetCompositeShaderSource();

}

#endif
