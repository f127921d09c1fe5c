/**
 * @file    ChartCurves.h
 * @brief   the series and guides of a chart in its plot
 */

#ifndef ChartCurves_h
#define ChartCurves_h

#include "ChartLayout.h"
#include "ChartMeasures.h"
#include "ChartScale.h"

#include <cstddef>

namespace penumbra
{

/// Lines as those of a series, or of a guide.
PlacedLines DrawAsSeries(
  const ChartLineSegments& lines, std::size_t series, const ChartMeasures& sizes);
PlacedLines DrawAsGuide(
  const ChartLineSegments& lines, std::size_t guide, const ChartMeasures& sizes);

/// Places lines, markers and labels in the plot, which has its place.
void PlaceCurves(const ChartDescription& chart, const ChartMeasures& sizes, const ChartScale& x,
  const ChartScale& y, ChartLayout& layout);

}

#endif
