#include "ChartCurves.h"

#include "ChartLabels.h"
#include "ChartText.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace penumbra
{
namespace
{
// A place for each pair of values, none where they cannot be shown.
using Curve = std::vector<std::optional<ChartPlace>>;

class Plot
{
public:
  Plot(const ChartBox& box, const ChartScale& x, const ChartScale& y)
    : Box(box)
    , X(x)
    , Y(y)
  {
  }

  Curve Place(const std::vector<double>& x, const std::vector<double>& y) const
  {
    Curve curve(x.size());
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      if (std::isfinite(x[i]))
      {
        curve[i] = ChartPlace{ this->Box.Left + this->X.PositionOf(x[i]) * this->Box.Width(),
          this->Box.Bottom + this->Y.PositionOf(y[i]) * this->Box.Height() };
      }
    }
    return curve;
  }

private:
  ChartBox Box;
  const ChartScale& X;
  const ChartScale& Y;
};

// From each point to the next, where both can be shown.
ChartLineSegments Join(const Curve& curve, const ChartBox& box)
{
  ChartLineSegments lines;
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    const auto line =
      curve[i - 1] && curve[i] ? PartWithin(box, { *curve[i - 1], *curve[i] }) : std::nullopt;
    if (line)
    {
      lines.push_back(*line);
    }
  }
  return lines;
}

// Many are smaller, so that they are still told apart.
double RadiusOfMarkers(const Curve& curve, const ChartMeasures& sizes)
{
  constexpr double few = 60.0;
  constexpr double smallest = 0.4;
  return sizes.MarkerRadius *
    std::clamp(std::sqrt(few / std::max<std::size_t>(1, curve.size())), smallest, 1.0);
}

void PlaceMarkers(
  const Curve& curve, const SeriesLook& look, double radius, std::vector<PlacedMarker>& markers)
{
  for (const auto& place : curve)
  {
    if (place)
    {
      markers.push_back({ *place, look, radius });
    }
  }
}

// Dark enough to be read.
TypeStyle InColorOf(std::size_t series, TypeStyle style)
{
  const ChartColor color = LookOfSeries(series).Color;
  for (int channel = 0; channel < 3; ++channel)
  {
    style.Color[channel] = 0.5 * (style.Color[channel] + color[channel]);
  }
  return style;
}

// Room between two labels, in multiples of their height.
constexpr double BesideLabel = 0.35;

struct Label
{
  LabelledPoint Point;
  TextLine Line;
};

void GatherLabels(
  const Curve& curve, const ChartSeries& series, const TypeStyle& style, std::vector<Label>& labels)
{
  for (std::size_t i = 0; i < std::min(curve.size(), series.Labels.size()); ++i)
  {
    const TextLine line{ InTypeface(series.Labels[i]), style };
    const double width = WidthOf(line);
    const double height = style.Size;
    if (curve[i] && width > 0.0)
    {
      labels.push_back({ { *curve[i], width + BesideLabel * height, height }, line });
    }
  }
}

// Labels are the last to be placed, as they are to cover nothing.
void WriteLabels(const std::vector<Label>& labels, const ChartMeasures& sizes, ChartLayout& layout)
{
  std::vector<LabelledPoint> points;
  std::vector<ChartPlace> markers;
  ChartLineSegments lines;
  std::transform(labels.begin(), labels.end(), std::back_inserter(points),
    [](const Label& label) { return label.Point; });
  std::transform(layout.Markers.begin(), layout.Markers.end(), std::back_inserter(markers),
    [](const PlacedMarker& marker) { return marker.Place; });
  for (const PlacedLines& curve : layout.Curves)
  {
    lines.insert(lines.end(), curve.Lines.begin(), curve.Lines.end());
  }
  const auto boxes = PlaceLabels(points, markers, sizes.MarkerRadius, lines, layout.Plot);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (boxes[i])
    {
      const ChartBox& box = *boxes[i];
      const double left = box.Left + 0.5 * BesideLabel * box.Height();
      layout.Texts.push_back({ labels[i].Line, { left, 0.5 * (box.Bottom + box.Top) } });
    }
  }
}
}

//------------------------------------------------------------------------------
PlacedLines DrawAsSeries(
  const ChartLineSegments& lines, std::size_t series, const ChartMeasures& sizes)
{
  return { lines, LookOfSeries(series).Color, sizes.CurveWidth };
}

//------------------------------------------------------------------------------
PlacedLines DrawAsGuide(
  const ChartLineSegments& lines, std::size_t guide, const ChartMeasures& sizes)
{
  const double width = sizes.CurveWidth;
  std::vector<double> lengths = DashesOfGuide(guide);
  for (double& length : lengths)
  {
    length *= width;
  }
  return { Dash(lines, lengths), ChartQuietInk, width };
}

//------------------------------------------------------------------------------
void PlaceCurves(const ChartDescription& chart, const ChartMeasures& sizes, const ChartScale& x,
  const ChartScale& y, ChartLayout& layout)
{
  const Plot plot(layout.Plot, x, y);
  for (std::size_t i = 0; i < chart.Guides.size(); ++i)
  {
    const Curve curve = plot.Place(chart.Guides[i].X, chart.Guides[i].Y);
    layout.Curves.push_back(DrawAsGuide(Join(curve, layout.Plot), i, sizes));
  }
  std::vector<Label> labels;
  for (std::size_t i = 0; i < chart.Series.size(); ++i)
  {
    const Curve curve = plot.Place(chart.Series[i].X, chart.Series[i].Y);
    layout.Curves.push_back(DrawAsSeries(Join(curve, layout.Plot), i, sizes));
    PlaceMarkers(curve, LookOfSeries(i), RadiusOfMarkers(curve, sizes), layout.Markers);
    GatherLabels(curve, chart.Series[i], InColorOf(i, sizes.Label), labels);
  }
  WriteLabels(labels, sizes, layout);
}

}
