/**
 * @file    ChartLegend.h
 * @brief   the names of a chart's series and guides, to the right of the plot
 */

#ifndef ChartLegend_h
#define ChartLegend_h

#include "ChartLayout.h"
#include "ChartMeasures.h"

namespace penumbra
{

/// What it needs beside the plot; nothing where there are no names.
double WidthOfLegend(const ChartDescription& chart, const ChartMeasures& sizes);

/// Down from the upper end of the plot, which has its place. What does not fit is counted in the
/// last line.
void PlaceLegend(const ChartDescription& chart, const ChartMeasures& sizes, ChartLayout& layout);

}

#endif
