#include "ChartFrame.h"

#include "ChartText.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
double WidestOf(const std::vector<ChartTick>& ticks, const TypeStyle& style)
{
  int widest = 0;
  for (const ChartTick& tick : ticks)
  {
    widest = std::max(widest, WidthOf({ tick.Label, style }));
  }
  return widest;
}

// Down from the chart's upper edge; returns what is left of the height.
double PlaceTitle(const ChartDescription& chart, const ChartMeasures& sizes, ChartLayout& layout)
{
  constexpr std::size_t mostLines = 3;
  std::vector<TextLine> lines = SplitLines(InTypeface(chart.Title), sizes.Title, sizes.BelowTitle);
  lines.resize(std::min(lines.size(), mostLines));
  double top = chart.Height - sizes.Margin;
  for (const TextLine& line : lines)
  {
    const double height = LineHeight(line.Style);
    layout.Texts.push_back({ FitInto(chart.Width - 2.0 * sizes.Margin, line.Text, line.Style),
      { sizes.Margin, top - 0.5 * height } });
    top -= height;
  }
  return chart.Title.empty() ? top : top - 0.8 * sizes.Type;
}

void PlaceMarksBetweenTicks(const ChartMeasures& sizes, ChartLayout& layout)
{
  const double length = 0.6 * sizes.TickLength;
  const ChartBox& plot = layout.Plot;
  PlacedLines marks{ {}, ChartQuietInk, sizes.LineWidth };
  for (const ChartTick& tick : layout.XTicks)
  {
    const double x = plot.Left + tick.Position * plot.Width();
    marks.Lines.push_back({ { x, plot.Bottom }, { x, plot.Bottom - length } });
  }
  for (const ChartTick& tick : layout.YTicks)
  {
    const double y = plot.Bottom + tick.Position * plot.Height();
    marks.Lines.push_back({ { plot.Left, y }, { plot.Left - length, y } });
  }
  layout.OtherLines.push_back(marks);
}
}

//------------------------------------------------------------------------------
void PlaceFrame(
  const ChartDescription& chart, const ChartMeasures& sizes, double besidePlot, ChartLayout& layout)
{
  const double axisTitleHeight = LineHeight(sizes.AxisTitle);
  const double besideAxis = sizes.TickLength + 0.4 * sizes.Type;
  const double belowTitle = PlaceTitle(chart, sizes, layout);
  const double yTitleMiddle = belowTitle - 0.5 * axisTitleHeight;
  const double xTitleMiddle = sizes.Margin + 0.5 * axisTitleHeight;

  ChartBox& plot = layout.Plot;
  plot.Left = sizes.Margin + WidestOf(layout.YTicks, sizes.Tick) + besideAxis;
  plot.Bottom = sizes.Margin + LineHeight(sizes.Tick) + besideAxis +
    (chart.XTitle.empty() ? 0.0 : axisTitleHeight + 0.3 * sizes.Type);
  plot.Right =
    chart.Width - sizes.Margin - std::max(besidePlot, 0.5 * WidestOf(layout.XTicks, sizes.Tick));
  plot.Top = chart.YTitle.empty() ? belowTitle : belowTitle - axisTitleHeight - 0.5 * sizes.Type;
  // VTK would round them.
  for (double* side : { &plot.Left, &plot.Bottom, &plot.Right, &plot.Top })
  {
    *side = std::round(*side);
  }

  const TextLine yTitle = FitInto(chart.Width - 2.0 * sizes.Margin, chart.YTitle, sizes.AxisTitle);
  layout.Texts.push_back({ yTitle, { sizes.Margin, yTitleMiddle } });
  const TextLine xTitle = FitInto(plot.Width(), chart.XTitle, sizes.AxisTitle);
  layout.Texts.push_back(
    { xTitle, { 0.5 * (plot.Left + plot.Right - WidthOf(xTitle)), xTitleMiddle } });
  PlaceMarksBetweenTicks(sizes, layout);
}

}
