/**
 * @file    ChartGeometry.h
 * @brief   places, boxes and lines in a chart
 *
 * In pixels from the chart's lower left corner, y runs up.
 */

#ifndef ChartGeometry_h
#define ChartGeometry_h

#include <optional>
#include <vector>

namespace penumbra
{

struct ChartPlace
{
  double X = 0.0;
  double Y = 0.0;
};

struct ChartBox
{
  double Left = 0.0;
  double Bottom = 0.0;
  double Right = 0.0;
  double Top = 0.0;

  double Width() const { return this->Right - this->Left; }
  double Height() const { return this->Top - this->Bottom; }
};

struct ChartLineSegment
{
  ChartPlace From;
  ChartPlace To;
};

using ChartLineSegments = std::vector<ChartLineSegment>;

bool Overlap(const ChartBox& a, const ChartBox& b);
bool LiesWithin(const ChartBox& inner, const ChartBox& outer);

/// What of a line lies in the box; nothing where it passes by.
std::optional<ChartLineSegment> PartWithin(const ChartBox& box, const ChartLineSegment& line);

/// The lines without gaps in their pattern: drawn and left out by turns, for these lengths, on from
/// one line to the next.
ChartLineSegments Dash(const ChartLineSegments& lines, const std::vector<double>& lengths);

}

#endif
