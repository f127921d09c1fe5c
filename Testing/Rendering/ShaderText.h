/**
 * @file ShaderText.h
 * @brief What of a shader's source is compiled, and which names stand for which requirement.
 */
#ifndef ShaderText_h
#define ShaderText_h

#include "LightingRequirements.h"

#include <string>
#include <vector>

namespace penumbra
{
/// The source without comments and without what #if NAME > NUMBER leaves out.
std::string GetCompiledText(const std::string& source);

/// Text that a program contains where, and only where, it needs the entry of this name.
/// @throw std::out_of_range for a name that is new here.
std::vector<std::string> GetSymbols(const std::string& entryName);

/// What of these requirements' symbols a source lacks, or has without need. Empty where all is
/// right.
std::string FindWrongSymbols(const LightingRequirements& requirements, const std::string& source);
}

#endif
