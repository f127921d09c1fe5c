/**
 * @file    SpeedCharts.h
 * @brief   what the speed study found, over the size of the volume, the lights and the picture
 */

#ifndef SpeedCharts_h
#define SpeedCharts_h

#include "SpeedRow.h"
#include "StudyChart.h"

#include <string>
#include <vector>

namespace penumbra
{

struct SpeedChart
{
  /// Without folder and extension.
  std::string File;
  ChartDescription Chart;
};

/// Processor time over the volume's edge, the number of lights and the picture's edge, of every
/// scene that has at least three of them.
std::vector<SpeedChart> MakeSpeedCharts(const std::vector<SpeedRow>& rows);

}

#endif
