/**
 * @file    ShaderSnippets.h
 * @brief   which snippets of GLSL a scene's requirements need, in GLSL order
 */

#ifndef ShaderSnippets_h
#define ShaderSnippets_h

#include "LightingRequirements.h"

#include <string>

namespace penumbra
{

/// What matter is, for view rays and shadow rays alike.
std::string GetMatterSnippets(const LightingRequirements& requirements);

/// How matter is lit and seen, to stand after the matter's snippets; continued: a draw that goes on
/// with what earlier draws of the same picture gathered.
std::string GetPictureSnippets(const LightingRequirements& requirements, bool continued);

}

#endif
