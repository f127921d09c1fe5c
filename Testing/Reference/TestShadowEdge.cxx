#include "Catch.h"
#include "ShadowEdge.h"

#include <cmath>

using namespace penumbra::reference;

namespace
{
/// By samples at three places of [0, 1].
std::optional<double> FindEdge(const MarginFunction& getMargin)
{
  std::vector<MarginSample> samples;
  for (const double position : { 0.11, 0.5, 0.89 })
  {
    samples.push_back({ position, getMargin(position) });
  }
  return ShadowEdge(samples, 0.0, 1.0).Find(getMargin, 1e-9);
}
}

TEST_CASE("An edge between samples is found")
{
  const auto edge = FindEdge([](double u) { return std::exp(u) - std::exp(0.37); });
  REQUIRE(edge);
  CHECK(*edge == Approx(0.37).margin(1e-8));
}

TEST_CASE("Edges that no two samples are apart are found by the margin's course")
{
  // Beyond the first and the last sample.
  const auto first = FindEdge([](double u) { return u - 0.04; });
  REQUIRE(first);
  CHECK(*first == Approx(0.04).margin(1e-8));
  const auto last = FindEdge([](double u) { return std::pow(u, 3.0) - std::pow(0.93, 3.0); });
  REQUIRE(last);
  CHECK(*last == Approx(0.93).margin(1e-8));
  // A short shadow between two samples.
  const auto getMargin = [](double u) { return 0.01 - std::pow(u - 0.67, 2.0); };
  const auto edge = FindEdge(getMargin);
  REQUIRE(edge);
  CHECK(getMargin(*edge) == Approx(0.0).margin(1e-8));
}

TEST_CASE("Without an edge none is found")
{
  CHECK_FALSE(FindEdge([](double u) { return u + 0.5; }));
  CHECK_FALSE(FindEdge([](double u) { return -0.2 - std::pow(u - 0.6, 2.0); }));
  CHECK_FALSE(FindEdge([](double) { return 0.0; }));
}

TEST_CASE("A margin of nothing is no shadow")
{
  const auto edge = FindEdge([](double u) { return std::max(u - 0.3, 0.0); });
  REQUIRE(edge);
  CHECK(*edge == Approx(0.3).margin(1e-8));
}
