/**
 * @file    SpeedMarkdown.h
 * @brief   what the speed study found, for people
 */

#ifndef SpeedMarkdown_h
#define SpeedMarkdown_h

#include "SpeedStudy.h"

#include <string>

namespace penumbra
{

/// Bounds, the thesis' test cases, a table a scene, one of all sizes and lights, and the notes.
std::string WriteSpeedMarkdown(const SpeedStudyResult& result);

}

#endif
