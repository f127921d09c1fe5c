#include "Catch.h"
#include "ReflectionFormulae.h"

#include <algorithm>
#include <cmath>

namespace
{
// Greatest error over all lights of which facets of about that slope make highlights, in parts of
// the lobe's peak, for an eye at that angle to the normal.
template <typename Shader, typename Formula>
double WorstError(double slope, double degrees, Shader&& shade, Formula&& expect)
{
  std::mt19937 generator(70);
  std::normal_distribution<double> normal;
  double worst = 0.0;
  double peak = 0.0;
  for (int sample = 0; sample < 5000; ++sample)
  {
    ReflectionDirections d;
    d.V = AtAngles(degrees, 360.0 * sample / 5000.0);
    const double x = slope * normal(generator);
    const Vector half = Normalized({ x, slope * normal(generator), 1.0 });
    d.L = Sum(2.0 * Dot(d.V, half), half, -1.0, d.V);
    const double expected = expect(d);
    peak = std::max(peak, expected);
    worst = std::max(worst, std::abs(shade(CosinesOf(d)) - expected));
  }
  return worst / peak;
}

struct Bound
{
  float Slope;
  double Error;
};
}

TEST_CASE("Narrow lobes keep their shape as far as ReflectionModels.md says")
{
  for (const Bound bound : { Bound{ 0.1f, 0.001 }, Bound{ 0.03f, 0.005 }, Bound{ 0.01f, 0.03 } })
  {
    const float slope = bound.Slope;
    for (const double angle : { 0.0, 30.0, 60.0, 75.0, 85.0 })
    {
      CHECK(
        WorstError(
          slope, angle,
          [=](const shader::ReflectionCosines& c)
          { return shader::ward::specularReflection(c, { slope }); },
          [=](const ReflectionDirections& d) { return formula::Ward(d, slope); }) < bound.Error);
      CHECK(WorstError(
              slope, angle,
              [=](const shader::ReflectionCosines& c) {
                return shader::cookTorrance::specularReflection(c, { slope, -1.0f });
              },
              [=](const ReflectionDirections& d)
              { return formula::CookTorranceBeckmann(d, slope); }) < bound.Error);
    }
  }
}
