/**
 * @file    ChartLabels.h
 * @brief   where the labels of points stand, so that they can be read
 */

#ifndef ChartLabels_h
#define ChartLabels_h

#include "ChartGeometry.h"

#include <optional>
#include <vector>

namespace penumbra
{

struct LabelledPoint
{
  ChartPlace Place;
  /// Of the label, in pixels.
  double Width;
  double Height;
};

/**
 * A box for each label, beside its point, within `plot`, on no marker and on no other label, and on
 * one line at most; none where there is no such place. All markers are circles of the same
 * radius.
 */
std::vector<std::optional<ChartBox>> PlaceLabels(const std::vector<LabelledPoint>& points,
  const std::vector<ChartPlace>& markers, double markerRadius, const ChartLineSegments& lines,
  const ChartBox& plot);

}

#endif
