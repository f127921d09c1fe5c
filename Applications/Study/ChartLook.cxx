#include "ChartLook.h"

#include <cmath>

namespace penumbra
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

constexpr ChartColor FromBytes(int red, int green, int blue)
{
  return { red / 255.0, green / 255.0, blue / 255.0 };
}

// Okabe and Ito's colours ("Color universal design", 2008), but for yellow, which is hardly seen on
// paper: a wine red is in its place. To protan, deutan and tritan eyes any two are at least 10.8
// apart by CIEDE2000.
constexpr std::array<ChartColor, 8> Palette{ FromBytes(0, 114, 178), FromBytes(213, 94, 0),
  FromBytes(0, 158, 115), FromBytes(204, 121, 167), FromBytes(86, 180, 233), FromBytes(136, 34, 85),
  FromBytes(230, 159, 0), FromBytes(34, 34, 34) };

// Corners on circles of the given radii by turns, the first one at an angle to the right.
MarkerOutline MakeStar(int corners, const std::vector<double>& radii, double firstAngle)
{
  MarkerOutline outline;
  for (int i = 0; i < corners; ++i)
  {
    const double radius = radii[i % radii.size()];
    const double angle = firstAngle + 2.0 * Pi * i / corners;
    outline.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return outline;
}

// Two bars that cross each other in the middle.
MarkerOutline MakeCross(double firstAngle)
{
  constexpr double length = 1.25;
  constexpr double halfWidth = 0.38;
  MarkerOutline outline;
  for (int arm = 0; arm < 4; ++arm)
  {
    const double angle = firstAngle + arm * Pi / 2.0;
    for (const auto& [along, across] : std::array<std::array<double, 2>, 3>{
           { { halfWidth, -halfWidth }, { length, -halfWidth }, { length, halfWidth } } })
    {
      outline.push_back({ along * std::cos(angle) - across * std::sin(angle),
        along * std::sin(angle) + across * std::cos(angle) });
    }
  }
  return outline;
}

const std::vector<MarkerOutline>& Markers()
{
  static const std::vector<MarkerOutline> markers{
    MakeStar(48, { 1.0 }, 0.0),            // circle
    MakeStar(4, { 1.25 }, Pi / 4.0),       // square
    MakeStar(3, { 1.45 }, Pi / 2.0),       // triangle
    MakeStar(4, { 1.35 }, 0.0),            // diamond
    MakeStar(3, { 1.45 }, -Pi / 2.0),      // triangle that points down
    MakeCross(0.0),                        // plus
    MakeStar(10, { 1.5, 0.68 }, Pi / 2.0), // star
    MakeCross(Pi / 4.0),                   // x
  };
  return markers;
}
}

//------------------------------------------------------------------------------
SeriesLook LookOfSeries(std::size_t index)
{
  const std::size_t round = index / Palette.size();
  return { Palette[index % Palette.size()], Markers()[(index + round) % Markers().size()] };
}

//------------------------------------------------------------------------------
std::vector<double> DashesOfGuide(std::size_t index)
{
  static const std::vector<std::vector<double>> dashes{ { 6.0, 3.5 }, { 1.2, 2.4 },
    { 7.0, 2.5, 1.2, 2.5 }, { 12.0, 3.5 } };
  return dashes[index % dashes.size()];
}

}
