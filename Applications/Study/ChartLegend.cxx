#include "ChartLegend.h"

#include "ChartCurves.h"
#include "ChartText.h"

#include <algorithm>
#include <string>

namespace penumbra
{
namespace
{
constexpr double MostOfWidth = 0.34;

double SwatchWidth(const ChartMeasures& sizes)
{
  return 2.4 * sizes.Type;
}

double BesideSwatch(const ChartMeasures& sizes)
{
  return 0.7 * sizes.Type;
}

double BesidePlot(const ChartMeasures& sizes)
{
  return 1.8 * sizes.Type;
}

double RoomForName(const ChartDescription& chart, const ChartMeasures& sizes)
{
  return MostOfWidth * chart.Width - SwatchWidth(sizes) - BesideSwatch(sizes);
}

std::vector<std::string> NamesOf(const ChartDescription& chart)
{
  std::vector<std::string> names;
  for (const ChartSeries& series : chart.Series)
  {
    names.push_back(series.Name);
  }
  for (const ChartLine& guide : chart.Guides)
  {
    names.push_back(guide.Name);
  }
  return names;
}

ChartLineSegment MakeSwatch(const ChartPlace& leftEnd, const ChartMeasures& sizes)
{
  return { leftEnd, { leftEnd.X + SwatchWidth(sizes), leftEnd.Y } };
}

ChartPlace MiddleOf(const ChartLineSegment& line)
{
  return { 0.5 * (line.From.X + line.To.X), 0.5 * (line.From.Y + line.To.Y) };
}
}

//------------------------------------------------------------------------------
double WidthOfLegend(const ChartDescription& chart, const ChartMeasures& sizes)
{
  double widest = 0.0;
  for (const std::string& name : NamesOf(chart))
  {
    const TextLine line = FitInto(RoomForName(chart, sizes), name, sizes.Legend);
    widest = std::max(
      widest, BesidePlot(sizes) + SwatchWidth(sizes) + BesideSwatch(sizes) + WidthOf(line));
  }
  return widest;
}

//------------------------------------------------------------------------------
void PlaceLegend(const ChartDescription& chart, const ChartMeasures& sizes, ChartLayout& layout)
{
  const std::vector<std::string> names = NamesOf(chart);
  const double rowHeight = 1.6 * sizes.Type;
  const auto rows = static_cast<std::size_t>(layout.Plot.Height() / rowHeight);
  const std::size_t shown = names.size() <= rows ? names.size() : rows - 1;
  ChartPlace place{ layout.Plot.Right + BesidePlot(sizes), layout.Plot.Top - 0.5 * rowHeight };
  const double nameLeft = place.X + SwatchWidth(sizes) + BesideSwatch(sizes);
  for (std::size_t i = 0; i < shown; ++i, place.Y -= rowHeight)
  {
    const ChartLineSegment swatch = MakeSwatch(place, sizes);
    if (i < chart.Series.size())
    {
      layout.OtherLines.push_back(DrawAsSeries({ swatch }, i, sizes));
      layout.Markers.push_back({ MiddleOf(swatch), LookOfSeries(i), sizes.MarkerRadius });
    }
    else
    {
      layout.OtherLines.push_back(DrawAsGuide({ swatch }, i - chart.Series.size(), sizes));
    }
    layout.Texts.push_back(
      { FitInto(RoomForName(chart, sizes), names[i], sizes.Legend), { nameLeft, place.Y } });
  }
  if (shown < names.size())
  {
    layout.Texts.push_back(
      { { "and " + std::to_string(names.size() - shown) + " more", sizes.Legend },
        { nameLeft, place.Y } });
  }
}

}
