#include "VisibleScalars.h"

#include <algorithm>
#include <limits>

namespace penumbra
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
using IntervalList = std::vector<std::array<double, 2>>;

// Values at ascending scalars, interpolated linearly, constant beyond both ends.
template <typename Scalar, typename Value>
void AddIntervals(
  int count, const Scalar& getScalar, const Value& getValue, IntervalList& intervals)
{
  for (int entry = 0; entry < count; ++entry)
  {
    if (getValue(entry) > 0.0)
    {
      const double low = entry > 0 ? getScalar(entry - 1) : -Infinity;
      const double high = entry + 1 < count ? getScalar(entry + 1) : Infinity;
      intervals.push_back({ low, high });
    }
  }
}

IntervalList Unite(IntervalList intervals)
{
  std::sort(intervals.begin(), intervals.end());
  IntervalList united;
  for (const auto& interval : intervals)
  {
    if (united.empty() || interval[0] > united.back()[1])
    {
      united.push_back(interval);
    }
    united.back()[1] = std::max(united.back()[1], interval[1]);
  }
  return united;
}
}

//------------------------------------------------------------------------------
VisibleScalars::VisibleScalars(const TransferFunctionTable& table)
{
  IntervalList intervals;
  if (table.Lookup == TransferFunctionLookup::Table || table.Steep)
  {
    const double step = (table.High - table.Low) / std::max(1, table.GetSize() - 1);
    const auto getScalar = [&](int entry) { return table.Low + entry * step; };
    AddIntervals(
      table.GetSize(), getScalar, [&](int entry) { return table.Extinction[entry]; }, intervals);
    // An entry more on either side, for how textures interpolate.
    const int last = table.GetSize() - 1;
    for (int cell = 0; table.Steep && cell < last; ++cell)
    {
      if (table.ExtinctionIntegral[cell + 1] > table.ExtinctionIntegral[cell])
      {
        intervals.push_back(
          { getScalar(std::max(cell - 1, 0)), getScalar(std::min(cell + 2, last)) });
      }
    }
  }
  if (table.Lookup == TransferFunctionLookup::Points)
  {
    AddIntervals(
      table.GetNumberOfPoints(), [&](int point) { return table.Low + table.PointScalars[point]; },
      [&](int point) { return table.PointColors[4 * point + 3]; }, intervals);
  }
  this->Intervals = Unite(std::move(intervals));
}

//------------------------------------------------------------------------------
bool VisibleScalars::AnyBetween(double low, double high) const
{
  const auto next = std::lower_bound(this->Intervals.begin(), this->Intervals.end(), low,
    [](const std::array<double, 2>& interval, double scalar) { return interval[1] < scalar; });
  return next != this->Intervals.end() && (*next)[0] <= high;
}

}
