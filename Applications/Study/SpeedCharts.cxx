#include "SpeedCharts.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace penumbra
{
namespace
{
struct Axis
{
  const char* Name;
  const char* Title;
  /// Of rows that differ along this axis alone.
  std::function<bool(const SpeedRow&)> IsAlong;
  std::function<double(const SpeedRow&)> Place;
  /// Cost grows with this power of the place, for comparison.
  double Power;
  const char* PowerName;
};

const std::vector<Axis>& Axes()
{
  static const std::vector<Axis> axes = {
    { "edge", "voxels along the longest edge",
      [](const SpeedRow& row) { return !row.IsOwnSize && row.Image == 512 && row.Lights == 1; },
      [](const SpeedRow& row) { return row.Edge; }, 1.0, "as the edge" },
    { "lights", "lights", [](const SpeedRow& row) { return row.IsOwnSize && row.Image == 512; },
      [](const SpeedRow& row) { return row.Lights; }, 1.0, "as the lights" },
    { "image", "pixels along the edge",
      [](const SpeedRow& row) { return row.IsOwnSize && row.Lights == 1; },
      [](const SpeedRow& row) { return row.Image; }, 2.0, "as the pixels" },
  };
  return axes;
}

std::vector<SpeedRow> RowsAlong(
  const std::vector<SpeedRow>& rows, const std::string& scene, const Axis& axis)
{
  std::vector<SpeedRow> along;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(along),
    [&](const SpeedRow& row) { return row.Scene == scene && axis.IsAlong(row); });
  std::stable_sort(along.begin(), along.end(),
    [&](const SpeedRow& left, const SpeedRow& right)
    { return axis.Place(left) < axis.Place(right); });
  return along;
}

// Two points make no curve.
std::vector<ChartSeries> CurvesOf(const std::vector<SpeedRow>& rows, const Axis& axis)
{
  std::vector<ChartSeries> curves;
  for (const SpeedRow& row : rows)
  {
    auto curve = std::find_if(curves.begin(), curves.end(),
      [&](const ChartSeries& series) { return series.Name == row.Variant; });
    if (curve == curves.end())
    {
      curve = curves.insert(curves.end(), ChartSeries{ row.Variant, {}, {}, {} });
    }
    curve->X.push_back(axis.Place(row));
    curve->Y.push_back(row.CpuSeconds);
  }
  curves.erase(std::remove_if(curves.begin(), curves.end(),
                 [](const ChartSeries& series) { return series.X.size() < 3; }),
    curves.end());
  return curves;
}

ChartLine GuideAlong(const ChartSeries& curve, const Axis& axis)
{
  const double ratio = std::pow(curve.X.back() / curve.X.front(), axis.Power);
  return { axis.PowerName, { curve.X.front(), curve.X.back() },
    { curve.Y.front(), curve.Y.front() * ratio } };
}
}

//------------------------------------------------------------------------------
std::vector<SpeedChart> MakeSpeedCharts(const std::vector<SpeedRow>& rows)
{
  std::vector<std::string> scenes;
  for (const SpeedRow& row : rows)
  {
    if (std::find(scenes.begin(), scenes.end(), row.Scene) == scenes.end())
    {
      scenes.push_back(row.Scene);
    }
  }
  std::vector<SpeedChart> charts;
  for (const std::string& scene : scenes)
  {
    for (const Axis& axis : Axes())
    {
      ChartDescription chart;
      chart.Series = CurvesOf(RowsAlong(rows, scene, axis), axis);
      if (chart.Series.empty())
      {
        continue;
      }
      chart.Title = scene + ": cost over " + axis.Title;
      chart.XTitle = axis.Title;
      chart.YTitle = "processor time of a frame, seconds";
      chart.Guides.push_back(GuideAlong(chart.Series.back(), axis));
      charts.push_back({ scene + "-cost-over-" + axis.Name, chart });
    }
  }
  return charts;
}

}
