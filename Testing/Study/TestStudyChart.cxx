#include "Catch.h"
#include "ChartFiles.h"
#include "ChartLook.h"
#include "ImageComparison.h"

#include <array>
#include <cmath>
#include <limits>

using namespace penumbra;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

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
