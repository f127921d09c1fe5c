/**
 * @file    StudyChart.h
 * @brief   charts of measured values, as pictures and as drawings that can be enlarged
 */

#ifndef StudyChart_h
#define StudyChart_h

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

/// Points with a marker each, joined by thin lines in their order. A pair of values that an axis
/// cannot show (not finite, or not positive where the axis is logarithmic) is left out, and the
/// line is broken there.
struct ChartSeries
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  /// What stands beside the points; may be empty. Labels that find no free place are left out.
  std::vector<std::string> Labels;
};

/// A line without points, as the Pareto front or a slope of order 2.
struct ChartLine
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
};

/**
 * The axes span all points of all series. Guides widen them by a quarter at most at either end, and
 * are cut off beyond that. The letters that VTK has are those of ASCII; all others become "?".
 */
struct ChartDescription
{
  /// What follows a line break stands below the title, in smaller type; two lines of it at most.
  std::string Title;
  std::string XTitle;
  std::string YTitle;
  bool LogX = true;
  bool LogY = true;
  std::vector<ChartSeries> Series;
  std::vector<ChartLine> Guides;
  /// In pixels. All type and lines grow with them.
  int Width = 900;
  int Height = 600;
};

/**
 * Writes FILE.png and FILE.svg. The same chart gives the same bytes. Renders without an X server.
 * @throw std::runtime_error that names the file and why, where one cannot be written or the size is
 * not from 300 to 2048 each way; then there is neither file, or what was there before.
 */
void WriteChart(const ChartDescription& chart, const std::filesystem::path& fileWithoutExtension);

}

#endif
