#include "Catch.h"
#include "ChartLook.h"
#include "ImageComparison.h"
#include "StudyChart.h"
#include "TemporaryFolder.h"

#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string ReadBytes(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

struct Files
{
  std::string Png;
  std::string Svg;
};

Files BytesOf(const ChartDescription& chart)
{
  const TemporaryFolder folder;
  WriteChart(chart, folder.PathOf("chart"));
  return { ReadBytes(folder.PathOf("chart.png")), ReadBytes(folder.PathOf("chart.svg")) };
}

vtkSmartPointer<vtkImageData> PictureOf(const ChartDescription& chart)
{
  const TemporaryFolder folder;
  WriteChart(chart, folder.PathOf("chart"));
  return ReadPNG(folder.PathOf("chart.png"));
}

bool HasColor(vtkImageData* picture, int x, int y, const ChartColor& color)
{
  const auto* levels = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
  for (int channel = 0; channel < 3; ++channel)
  {
    if (std::abs(levels[channel] - 255.0 * color[channel]) > 1.0)
    {
      return false;
    }
  }
  return true;
}

struct Spot
{
  double X = 0.0;
  double Y = 0.0;
  int Count = 0;
};

// The middle of all pixels of a series' colour but for those of the legend, in the last tenth.
Spot FindSeries(vtkImageData* picture, std::size_t series)
{
  const int* size = picture->GetDimensions();
  Spot spot;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < 0.9 * size[0]; ++x)
    {
      if (HasColor(picture, x, y, LookOfSeries(series).Color))
      {
        spot = { spot.X + x, spot.Y + y, spot.Count + 1 };
      }
    }
  }
  return { spot.X / spot.Count, spot.Y / spot.Count, spot.Count };
}

// Where on an axis (0 is X) the lines of the grid are, seen along the other axis, where no marker
// is.
std::vector<double> FindGridLines(vtkImageData* picture, int axis)
{
  constexpr int besideAxis = 60;
  const int end = axis == 0 ? picture->GetDimensions()[0] * 9 / 10 : picture->GetDimensions()[1];
  std::vector<double> lines;
  int first = 0;
  for (int i = besideAxis; i < end; ++i)
  {
    const bool isLine = axis == 0 ? !HasColor(picture, i, besideAxis, ChartPaper)
                                  : !HasColor(picture, besideAxis, i, ChartPaper);
    if (isLine && first == 0)
    {
      first = i;
    }
    if (!isLine && first > 0)
    {
      lines.push_back(0.5 * (first + i - 1));
      first = 0;
    }
  }
  return lines;
}

ChartSeries At(const std::string& name, double x, double y)
{
  return { name, { x }, { y }, {} };
}

// What a study would draw.
ChartDescription MakeChart()
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

TEST_CASE("A chart is a picture and a drawing of the size that was asked for")
{
  const TemporaryFolder folder;
  ChartDescription chart = MakeChart();
  chart.Width = 640;
  chart.Height = 400;
  WriteChart(chart, folder.PathOf("error-1.5"));
  CHECK(folder.Names() == std::vector<std::string>{ "error-1.5.png", "error-1.5.svg" });
  const auto picture = ReadPNG(folder.PathOf("error-1.5.png"));
  CHECK(picture->GetDimensions()[0] == 640);
  CHECK(picture->GetDimensions()[1] == 400);
  const auto drawing = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromFile(folder.PathOf("error-1.5.svg").c_str()));
  REQUIRE(drawing);
  CHECK(drawing->GetAttribute("width") == std::string("640"));
  CHECK(drawing->GetAttribute("height") == std::string("400"));
  CHECK(drawing->GetAttribute("viewBox") == std::string("0 0 2560 1600"));
}

TEST_CASE("Markers stand where the grid lines of their values cross")
{
  ChartDescription chart;
  chart.LogX = GENERATE(false, true);
  chart.LogY = GENERATE(false, true);
  const auto valuesOn = [](bool isLogarithmic) {
    return isLogarithmic ? std::array{ 0.1, 1.0, 10.0 } : std::array{ 0.0, 1.0, 2.0 };
  };
  const auto x = valuesOn(chart.LogX);
  const auto y = valuesOn(chart.LogY);
  chart.Series = { At("a", x[0], y[0]), At("b", x[1], y[1]), At("c", x[2], y[2]) };
  const auto picture = PictureOf(chart);
  const auto xLines = FindGridLines(picture, 0);
  const auto yLines = FindGridLines(picture, 1);
  REQUIRE(xLines.size() == (chart.LogX ? 3 : 5)); // there are halves too
  REQUIRE(yLines.size() == (chart.LogY ? 3 : 5));
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Spot spot = FindSeries(picture, i);
    CAPTURE(chart.LogX, chart.LogY, i, spot.X, spot.Y, xLines, yLines);
    CHECK(std::abs(spot.X - xLines[i * (xLines.size() - 1) / 2]) <= 0.75);
    CHECK(std::abs(spot.Y - yLines[i * (yLines.size() - 1) / 2]) <= 0.75);
    CHECK(spot.Count > 30);
    CHECK(spot.Count < 120);
  }
}

TEST_CASE("The same chart gives the same bytes, whatever was drawn before")
{
  const Files first = BytesOf(MakeChart());
  ChartDescription manyStyles = MakeChart();
  for (int i = 0; i < 12; ++i)
  {
    manyStyles.Series.push_back({ "n", { 1.0 + i }, { 2.0 }, { "label" } });
  }
  for (const int width : { 700, 1100, 1500 })
  {
    manyStyles.Width = width;
    manyStyles.Height = width;
    BytesOf(manyStyles);
  }
  const Files second = BytesOf(MakeChart());
  CHECK((first.Png == second.Png));
  CHECK((first.Svg == second.Svg));
}

TEST_CASE("The drawing is XML and has the titles and all names")
{
  const std::string svg = BytesOf(MakeChart()).Svg;
  const auto drawing =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
  REQUIRE(drawing);
  CHECK(drawing->GetName() == std::string("svg"));
  const auto textOf = [&drawing](const char* name)
  {
    vtkXMLDataElement* element = drawing->FindNestedElementWithName(name);
    return std::string(element ? element->GetCharacterData() : "");
  };
  CHECK_THAT(textOf("title"),
    Catch::Matchers::ContainsSubstring("Error over time\nof a <scene> & \"another\""));
  for (const char* name : { "RMSE over time", "rays", "maps", "Pareto <front>" })
  {
    CHECK_THAT(textOf("desc"), Catch::Matchers::ContainsSubstring(name));
  }
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

TEST_CASE("Where a point is left out its line is broken")
{
  const auto hasLineInTheMiddle = [](const ChartSeries& line)
  {
    // The ends are seen, as they come last.
    ChartDescription chart;
    chart.Series = { line, At("b", 1.0, 1.0), At("c", 10.0, 3.0) };
    const auto picture = PictureOf(chart);
    const Spot from = FindSeries(picture, 1);
    const Spot to = FindSeries(picture, 2);
    return !HasColor(picture, static_cast<int>(std::lround(0.5 * (from.X + to.X))),
      static_cast<int>(std::lround(0.5 * (from.Y + to.Y))), ChartPaper);
  };
  CHECK(hasLineInTheMiddle({ "a", { 1.0, 10.0 }, { 1.0, 3.0 }, {} }));
  CHECK_FALSE(hasLineInTheMiddle({ "a", { 1.0, 2.0, 10.0 }, { 1.0, NaN, 3.0 }, {} }));
}

TEST_CASE("A chart that cannot be written leaves nothing, and what was there")
{
  const TemporaryFolder folder;
  folder.Write("file", "");
  folder.Write("taken.svg/inside", "");
  folder.Write("old.png", "old picture");
  folder.Write("old.svg", "old drawing");
  const auto names = folder.Names();
  const auto errorOf = [&folder](const std::string& name, const ChartDescription& chart)
  {
    try
    {
      WriteChart(chart, folder.PathOf(name));
    }
    catch (const std::runtime_error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(errorOf("missing/chart", MakeChart()),
    Catch::Matchers::ContainsSubstring("missing/chart.png") &&
      Catch::Matchers::ContainsSubstring("no folder"));
  CHECK_THAT(
    errorOf("file/chart", MakeChart()), Catch::Matchers::ContainsSubstring("file/chart.png"));
  CHECK_THAT(errorOf("taken", MakeChart()),
    Catch::Matchers::ContainsSubstring("taken.svg, which is a folder"));
  ChartDescription small = MakeChart();
  small.Width = 299;
  CHECK_THAT(errorOf("old", small),
    Catch::Matchers::ContainsSubstring("old: a chart of 299 x 600 pixels; accepted: from 300"));
  CHECK(folder.Names() == names);
  CHECK(ReadBytes(folder.PathOf("old.png")) == "old picture");
  CHECK(ReadBytes(folder.PathOf("old.svg")) == "old drawing");
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
  const Files files = BytesOf(chart);
  CHECK(files.Png.size() > 1000);
  const auto drawing = vtkSmartPointer<vtkXMLDataElement>::Take(
    vtkXMLUtilities::ReadElementFromString(files.Svg.c_str()));
  CHECK(drawing);
}
