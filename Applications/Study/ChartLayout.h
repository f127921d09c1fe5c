/**
 * @file    ChartLayout.h
 * @brief   where in a chart everything stands
 *
 * In pixels from the chart's lower left corner, y runs up.
 */

#ifndef ChartLayout_h
#define ChartLayout_h

#include "ChartGeometry.h"
#include "ChartLook.h"
#include "ChartTicks.h"
#include "SheetText.h"
#include "StudyChart.h"

#include <array>
#include <vector>

namespace penumbra
{

struct PlacedLines
{
  ChartLineSegments Lines;
  ChartColor Color;
  double Width;
};

struct PlacedMarker
{
  ChartPlace Place;
  SeriesLook Look;
  double Radius;
};

struct PlacedText
{
  TextLine Line;
  /// Halfway up its left end.
  ChartPlace Place;
};

struct ChartLayout
{
  std::array<int, 2> Size{ 0, 0 };
  /// Between the ends of the axes.
  ChartBox Plot;
  std::vector<ChartTick> XTicks;
  std::vector<ChartTick> YTicks;
  /// Of series and guides; all lie in the plot.
  std::vector<PlacedLines> Curves;
  /// Of the legend, and between the ticks.
  std::vector<PlacedLines> OtherLines;
  std::vector<PlacedMarker> Markers;
  std::vector<PlacedText> Texts;
};

ChartLayout LayOutChart(const ChartDescription& chart);

}

#endif
