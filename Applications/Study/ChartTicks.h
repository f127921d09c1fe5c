/**
 * @file    ChartTicks.h
 * @brief   the values that are marked on an axis of a chart
 */

#ifndef ChartTicks_h
#define ChartTicks_h

#include "ChartScale.h"

#include <string>
#include <vector>

namespace penumbra
{

struct ChartTick
{
  double Position = 0.0;
  /// As 0.1, 1000 or 1e-7. Empty at the smaller marks between those that have a number.
  std::string Label;
};

/**
 * On a logarithmic axis powers of ten where it has three of them or more, else such with multiples,
 * else equal steps; on others equal steps.
 */
std::vector<ChartTick> MakeTicks(const ChartScale& scale, int mostLabels);

}

#endif
