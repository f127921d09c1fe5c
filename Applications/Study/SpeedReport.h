/**
 * @file    SpeedReport.h
 * @brief   what the speed study found, for programs
 */

#ifndef SpeedReport_h
#define SpeedReport_h

#include "SpeedStudy.h"

#include <string>

namespace penumbra
{

/// Comma-separated values with one line a row and names at the top.
std::string WriteSpeedCsv(const SpeedStudyResult& result);

/// Versions, machine, `command`, bounds and rows.
std::string WriteSpeedJson(const SpeedStudyResult& result, const std::string& command);

/**
 * What a choice of technique can be calibrated from: scene, size, technique, resolution, error
 * against rays with half the shadow step, and costs in unlit frames of the stock mapper, of every
 * shadow with one light.
 */
std::string WriteSpeedCalibration(const SpeedStudyResult& result, const std::string& command);

}

#endif
