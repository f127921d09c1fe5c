#include "ChartGeometry.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
ChartPlace Along(const ChartLineSegment& line, double share)
{
  return { line.From.X + share * (line.To.X - line.From.X),
    line.From.Y + share * (line.To.Y - line.From.Y) };
}

// What rounding has moved out of the box.
ChartPlace Clamp(const ChartBox& box, const ChartPlace& place)
{
  return { std::clamp(place.X, box.Left, box.Right), std::clamp(place.Y, box.Bottom, box.Top) };
}
}

//------------------------------------------------------------------------------
bool Overlap(const ChartBox& a, const ChartBox& b)
{
  return a.Left < b.Right && b.Left < a.Right && a.Bottom < b.Top && b.Bottom < a.Top;
}

//------------------------------------------------------------------------------
bool LiesWithin(const ChartBox& inner, const ChartBox& outer)
{
  return inner.Left >= outer.Left && inner.Right <= outer.Right && inner.Bottom >= outer.Bottom &&
    inner.Top <= outer.Top;
}

//------------------------------------------------------------------------------
std::optional<ChartLineSegment> PartWithin(const ChartBox& box, const ChartLineSegment& line)
{
  double first = 0.0;
  double last = 1.0;
  const auto cut = [&first, &last](double from, double to, double lowest, double highest)
  {
    if (from == to)
    {
      return from >= lowest && from <= highest;
    }
    const double atLowest = (lowest - from) / (to - from);
    const double atHighest = (highest - from) / (to - from);
    first = std::max(first, std::min(atLowest, atHighest));
    last = std::min(last, std::max(atLowest, atHighest));
    return first < last;
  };
  if (!cut(line.From.X, line.To.X, box.Left, box.Right) ||
    !cut(line.From.Y, line.To.Y, box.Bottom, box.Top))
  {
    return std::nullopt;
  }
  return ChartLineSegment{ Clamp(box, Along(line, first)), Clamp(box, Along(line, last)) };
}

//------------------------------------------------------------------------------
ChartLineSegments Dash(const ChartLineSegments& lines, const std::vector<double>& lengths)
{
  ChartLineSegments dashes;
  std::size_t turn = 0;
  double left = lengths[0];
  for (const ChartLineSegment& line : lines)
  {
    const double length = std::hypot(line.To.X - line.From.X, line.To.Y - line.From.Y);
    for (double done = 0.0; done < length;)
    {
      const double next = std::min(left, length - done);
      if (turn % 2 == 0)
      {
        dashes.push_back({ Along(line, done / length), Along(line, (done + next) / length) });
      }
      done += next;
      left -= next;
      if (left <= 0.0)
      {
        turn = (turn + 1) % lengths.size();
        left = lengths[turn];
      }
    }
  }
  return dashes;
}

}
