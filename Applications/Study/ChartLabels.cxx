#include "ChartLabels.h"

#include <algorithm>
#include <array>

namespace penumbra
{
namespace
{
ChartBox BoxAround(const ChartPlace& place, double radius)
{
  return { place.X - radius, place.Y - radius, place.X + radius, place.Y + radius };
}

// From the best to the worst: in the corners, where lines seldom run, then above, below, right and
// left of the point.
std::array<ChartBox, 8> PlacesBeside(const LabelledPoint& point, double radius)
{
  const auto box = [&point](double left, double bottom) {
    return ChartBox{ left, bottom, left + point.Width, bottom + point.Height };
  };
  constexpr double diagonal = 0.8;
  const double toCorner = diagonal * radius;
  const double right = point.Place.X + toCorner;
  const double left = point.Place.X - toCorner - point.Width;
  const double above = point.Place.Y + toCorner;
  const double below = point.Place.Y - toCorner - point.Height;
  const double centred = point.Place.X - 0.5 * point.Width;
  const double middle = point.Place.Y - 0.5 * point.Height;
  return { box(right, above), box(left, above), box(right, below), box(left, below),
    box(centred, point.Place.Y + radius), box(centred, point.Place.Y - radius - point.Height),
    box(point.Place.X + radius, middle), box(point.Place.X - radius - point.Width, middle) };
}

class Labels
{
public:
  Labels(const std::vector<ChartPlace>& markers, double markerRadius,
    const ChartLineSegments& lines, const ChartBox& plot)
    : Radius(markerRadius)
    , Lines(lines)
    , Plot(plot)
  {
    for (const ChartPlace& marker : markers)
    {
      this->Taken.push_back(BoxAround(marker, markerRadius));
    }
  }

  std::optional<ChartBox> Place(const LabelledPoint& point)
  {
    constexpr std::size_t mostLines = 1;
    std::optional<ChartBox> best;
    std::size_t fewest = mostLines + 1;
    for (const ChartBox& box : PlacesBeside(point, 1.4 * this->Radius))
    {
      const std::size_t crossed = this->IsFree(box) ? this->CountLinesOn(box) : fewest;
      if (crossed < fewest)
      {
        best = box;
        fewest = crossed;
      }
    }
    if (best)
    {
      this->Taken.push_back(*best);
    }
    return best;
  }

private:
  bool IsFree(const ChartBox& box) const
  {
    return LiesWithin(box, this->Plot) &&
      std::none_of(this->Taken.begin(), this->Taken.end(),
        [&box](const ChartBox& other) { return Overlap(box, other); });
  }

  std::size_t CountLinesOn(const ChartBox& box) const
  {
    return std::count_if(this->Lines.begin(), this->Lines.end(),
      [&box](const ChartLineSegment& line) { return PartWithin(box, line).has_value(); });
  }

  double Radius;
  const ChartLineSegments& Lines;
  ChartBox Plot;
  std::vector<ChartBox> Taken;
};
}

//------------------------------------------------------------------------------
std::vector<std::optional<ChartBox>> PlaceLabels(const std::vector<LabelledPoint>& points,
  const std::vector<ChartPlace>& markers, double markerRadius, const ChartLineSegments& lines,
  const ChartBox& plot)
{
  Labels labels(markers, markerRadius, lines, plot);
  std::vector<std::optional<ChartBox>> places;
  for (const LabelledPoint& point : points)
  {
    places.push_back(labels.Place(point));
  }
  return places;
}

}
