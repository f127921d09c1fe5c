#include "ChartLayout.h"

#include "ChartCurves.h"
#include "ChartFrame.h"
#include "ChartLegend.h"

#include <algorithm>
#include <limits>

namespace penumbra
{
namespace
{
template <class Curve>
std::vector<double> Gather(const std::vector<Curve>& curves, std::vector<double> Curve::*values)
{
  std::vector<double> all;
  for (const Curve& curve : curves)
  {
    all.insert(all.end(), (curve.*values).begin(), (curve.*values).end());
  }
  return all;
}

// Pairs of values with one that an axis cannot show are nowhere, and do not widen the other axis.
template <class Curve>
void LeaveOutUnshowable(const ChartDescription& chart, std::vector<Curve>& curves)
{
  for (Curve& curve : curves)
  {
    const std::size_t count = std::min(curve.X.size(), curve.Y.size());
    curve.X.resize(count);
    curve.Y.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!CanShow(curve.X[i], chart.LogX) || !CanShow(curve.Y[i], chart.LogY))
      {
        curve.X[i] = curve.Y[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
}

// The numbers that stand beside each other on an axis without touching.
int NumbersWithin(int pixels, double each)
{
  return std::clamp(static_cast<int>(pixels / each), 5, 8);
}
}

//------------------------------------------------------------------------------
ChartLayout LayOutChart(const ChartDescription& description)
{
  ChartDescription chart = description;
  LeaveOutUnshowable(chart, chart.Series);
  LeaveOutUnshowable(chart, chart.Guides);
  const ChartMeasures sizes(chart.Width, chart.Height);
  const ChartScale x(
    Gather(chart.Series, &ChartSeries::X), Gather(chart.Guides, &ChartLine::X), chart.LogX);
  const ChartScale y(
    Gather(chart.Series, &ChartSeries::Y), Gather(chart.Guides, &ChartLine::Y), chart.LogY);
  ChartLayout layout;
  layout.Size = { chart.Width, chart.Height };
  layout.XTicks = MakeTicks(x, NumbersWithin(chart.Width, 8.0 * sizes.Type));
  layout.YTicks = MakeTicks(y, NumbersWithin(chart.Height, 4.0 * sizes.Type));
  PlaceFrame(chart, sizes, WidthOfLegend(chart, sizes), layout);
  PlaceLegend(chart, sizes, layout);
  PlaceCurves(chart, sizes, x, y, layout);
  return layout;
}

}
