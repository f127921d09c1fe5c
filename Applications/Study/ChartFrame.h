/**
 * @file    ChartFrame.h
 * @brief   the titles and axes of a chart, and the room that they leave for its plot
 */

#ifndef ChartFrame_h
#define ChartFrame_h

#include "ChartLayout.h"
#include "ChartMeasures.h"

namespace penumbra
{

/// Needs the layout's size and ticks, and `besidePlot` pixels to the right of the plot for the
/// legend.
void PlaceFrame(const ChartDescription& chart, const ChartMeasures& sizes, double besidePlot,
  ChartLayout& layout);

}

#endif
