/**
 * @file    SpeedRenderingReport.h
 * @brief   what a rendering's report tells the speed study
 */

#ifndef SpeedRenderingReport_h
#define SpeedRenderingReport_h

#include "SpeedRow.h"

#include <nlohmann/json_fwd.hpp>

namespace penumbra
{

/// Technique, resolution and counts.
void ReadReport(const nlohmann::json& report, SpeedRow& row);

/// Whether rays leap over empty space.
bool SkipsEmptySpace(const nlohmann::json& report);

}

#endif
