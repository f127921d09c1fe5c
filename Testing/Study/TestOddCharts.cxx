#include "Catch.h"
#include "ChartFiles.h"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

TEST_CASE("What an axis cannot show is left out")
{
  ChartDescription chart;
  chart.Series = { { "a", { 1.0, 10.0, 100.0 }, { 3.0, 2.0, 1.0 }, { "l", "m", "n" } } };
  const std::string expected = BytesOf(chart).Png;
  chart.Series[0].X = { NaN, 1e9, 1.0, 10.0, 100.0, -5.0, 0.0, Infinity, 1e-9, 7.0 };
  chart.Series[0].Y = { 1.0, 0.0, 3.0, 2.0, 1.0, 5.0, 5.0, 5.0, -Infinity };
  chart.Series[0].Labels = { "o", "o", "l", "m", "n", "o", "o", "o", "o", "o", "o" };
  CHECK((BytesOf(chart).Png == expected));
}

TEST_CASE("Charts of odd values are whole")
{
  constexpr double huge = std::numeric_limits<double>::max();
  ChartDescription chart;
  SECTION("nothing at all") {}
  SECTION("one point")
  {
    chart.Series = { At("one", 0.37, 12.0) };
  }
  SECTION("an empty series beside a guide")
  {
    chart.Series = { { "empty", {}, {}, {} } };
    chart.Guides = { { "line", { 1.0, 10.0 }, { 1.0, NaN } } };
  }
  SECTION("hundreds of points with labels")
  {
    ChartSeries series;
    for (int i = 0; i < 500; ++i)
    {
      series.X.push_back(1.0 + i);
      series.Y.push_back(2.0 + std::sin(0.1 * i));
      series.Labels.push_back(std::to_string(i));
    }
    chart.Series = { series };
  }
  SECTION("huge ranges")
  {
    chart.LogX = GENERATE(false, true);
    chart.Series = { { "huge", { -huge, 0.0, 1.0, huge }, { 5e-324, 1.0, 2.0, huge }, {} } };
    chart.Guides = { { "guide", { -huge, huge }, { huge, 1e-300 } } };
  }
  SECTION("many series of long names that are not ASCII")
  {
    chart.Title = std::string(400, 'T') + "\xff\x01\xc3\xa4";
    chart.XTitle = chart.YTitle = chart.Title;
    chart.Title += std::string(100, '\n') + "line";
    chart.Width = chart.Height = 300;
    for (int i = 0; i < 70; ++i)
    {
      chart.Series.push_back(At(chart.Title, 1.0 + i, 1.0));
    }
  }
  const ChartFiles files = BytesOf(chart);
  CHECK(files.Png.size() > 1000);
  const auto drawing = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromString(files.Svg.c_str()));
  CHECK(drawing);
}
