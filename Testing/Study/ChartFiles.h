/**
 * @file ChartFiles.h
 * @brief Charts to draw, and the bytes of what was drawn.
 */
#ifndef ChartFiles_h
#define ChartFiles_h

#include "StudyChart.h"
#include "TemporaryFolder.h"

#include <fstream>
#include <iterator>
#include <string>

namespace penumbra
{
inline std::string ReadBytes(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

struct ChartFiles
{
  std::string Png;
  std::string Svg;
};

inline ChartFiles BytesOf(const ChartDescription& chart)
{
  const TemporaryFolder folder;
  WriteChart(chart, folder.PathOf("chart"));
  return { ReadBytes(folder.PathOf("chart.png")), ReadBytes(folder.PathOf("chart.svg")) };
}

/// A series of one point.
inline ChartSeries At(const std::string& name, double x, double y)
{
  return { name, { x }, { y }, {} };
}

/// What a study would draw.
inline ChartDescription MakeChart()
{
  ChartDescription chart;
  chart.Title = "Error over time\nof a <scene> & \"another\"";
  chart.XTitle = "time";
  chart.YTitle = "RMSE";
  chart.Series = { { "rays", { 1.0, 3.0, 9.0 }, { 10.0, 3.0, 0.4 }, { "1", "1/2", "1/4" } },
    { "maps", { 0.5, 1.5 }, { 30.0, 20.0 }, {} } };
  chart.Guides = { { "Pareto <front>", { 0.5, 1.0, 9.0 }, { 30.0, 10.0, 0.4 } } };
  return chart;
}
}

#endif
