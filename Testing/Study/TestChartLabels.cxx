#include "Catch.h"
#include "ChartLabels.h"
#include "ChartLook.h"

#include <cmath>
#include <random>
#include <set>

using namespace penumbra;

namespace
{
constexpr ChartBox Plot{ 10.0, 20.0, 210.0, 120.0 };
constexpr double Radius = 4.0;

ChartBox BoxOf(const ChartPlace& marker)
{
  return { marker.X - Radius, marker.Y - Radius, marker.X + Radius, marker.Y + Radius };
}
}

TEST_CASE("Labels lie in the plot, on no marker and on no other label")
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(Plot.Left, Plot.Right);
  std::uniform_real_distribution<double> y(Plot.Bottom, Plot.Top);
  std::vector<ChartPlace> markers;
  std::vector<LabelledPoint> points;
  for (int i = 0; i < 40; ++i)
  {
    markers.push_back({ x(random), y(random) });
    points.push_back({ markers.back(), 16.0, 10.0 });
  }
  const auto boxes = PlaceLabels(points, markers, Radius, {}, Plot);
  REQUIRE(boxes.size() == points.size());
  int placed = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (boxes[i])
    {
      ++placed;
      CHECK(LiesWithin(*boxes[i], Plot));
      CHECK(boxes[i]->Width() == Approx(16.0));
      for (const ChartPlace& marker : markers)
      {
        CHECK_FALSE(Overlap(*boxes[i], BoxOf(marker)));
      }
      for (std::size_t j = 0; j < i; ++j)
      {
        CHECK_FALSE((boxes[j] && Overlap(*boxes[i], *boxes[j])));
      }
    }
  }
  CHECK(placed > 15);
  CHECK(placed < 40); // there is no room for all
}

TEST_CASE("A label is beside its point, and evades lines")
{
  const ChartPlace point{ 100.0, 70.0 };
  const std::vector<LabelledPoint> points{ { point, 16.0, 10.0 } };
  const auto alone = PlaceLabels(points, { point }, Radius, {}, Plot).front();
  REQUIRE(alone);
  CHECK(alone->Left > point.X);
  CHECK(alone->Left < point.X + 3.0 * Radius);
  CHECK(alone->Bottom > point.Y);
  CHECK(alone->Bottom < point.Y + 3.0 * Radius);
  const ChartLineSegments rising{ { { 50.0, 20.0 }, { 150.0, 120.0 } } };
  const auto evading = PlaceLabels(points, { point }, Radius, rising, Plot).front();
  REQUIRE(evading);
  CHECK_FALSE(PartWithin(*evading, rising.front()));
}

TEST_CASE("Of a line remains what lies in the box")
{
  const auto crossing = PartWithin(Plot, { { -90.0, 70.0 }, { 310.0, 70.0 } });
  REQUIRE(crossing);
  CHECK(crossing->From.X == Approx(Plot.Left));
  CHECK(crossing->To.X == Approx(Plot.Right));
  CHECK(crossing->To.Y == Approx(70.0));
  const auto far = PartWithin(Plot, { { 100.0, 70.0 }, { 1e300, 1e300 } });
  REQUIRE(far);
  CHECK(LiesWithin({ far->To.X, far->To.Y, far->To.X, far->To.Y }, Plot));
  CHECK_FALSE(PartWithin(Plot, { { 0.0, 0.0 }, { 300.0, 10.0 } }));
  CHECK_FALSE(PartWithin(Plot, { { 0.0, 100.0 }, { 50.0, 200.0 } }));
}

TEST_CASE("Dashes go on from one line to the next")
{
  const auto dashes =
    Dash({ { { 0.0, 0.0 }, { 7.0, 0.0 } }, { { 7.0, 0.0 }, { 7.0, 7.0 } } }, { 3.0, 2.0 });
  REQUIRE(dashes.size() == 4);
  CHECK(dashes[0].To.X == Approx(3.0));
  CHECK(dashes[1].From.X == Approx(5.0));
  CHECK(dashes[1].To.X == Approx(7.0));
  CHECK(dashes[2].From.Y == Approx(0.0).margin(1e-9));
  CHECK(dashes[2].To.Y == Approx(1.0));
  CHECK(dashes[3].From.Y == Approx(3.0));
  CHECK(dashes[3].To.Y == Approx(6.0));
}

TEST_CASE("Series differ in what they look like")
{
  std::set<ChartColor> colors;
  std::set<MarkerOutline> markers;
  std::set<std::pair<ChartColor, MarkerOutline>> looks;
  for (std::size_t i = 0; i < 64; ++i)
  {
    const SeriesLook look = LookOfSeries(i);
    looks.insert({ look.Color, look.Marker });
    if (i < 8)
    {
      colors.insert(look.Color);
      markers.insert(look.Marker);
    }
  }
  CHECK(colors.size() == 8);
  CHECK(markers.size() == 8);
  CHECK(looks.size() == 64);
}
