#include "Catch.h"
#include "ChartTicks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace penumbra;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> Labels(const ChartScale& scale, int most = 8)
{
  std::vector<std::string> labels;
  for (const ChartTick& tick : MakeTicks(scale, most))
  {
    if (!tick.Label.empty())
    {
      labels.push_back(tick.Label);
    }
  }
  return labels;
}

// Where the mark stands that has this label.
double PositionOf(const ChartScale& scale, const std::string& label)
{
  const auto ticks = MakeTicks(scale, 8);
  const auto tick = std::find_if(ticks.begin(), ticks.end(),
    [&label](const ChartTick& candidate) { return candidate.Label == label; });
  return tick == ticks.end() ? NaN : tick->Position;
}
}

TEST_CASE("Equal factors are equally far apart on a logarithmic axis, equal steps on a linear one")
{
  const ChartScale logarithmic({ 0.01, 100.0 }, {}, true);
  CHECK(logarithmic.PositionOf(1.0) == Approx(0.5));
  CHECK(logarithmic.PositionOf(10.0) - logarithmic.PositionOf(1.0) ==
    Approx(logarithmic.PositionOf(0.2) - logarithmic.PositionOf(0.02)));
  const ChartScale linear({ -1.0, 3.0 }, {}, false);
  CHECK(linear.PositionOf(1.0) == Approx(0.5));
  CHECK(linear.PositionOf(2.0) - linear.PositionOf(1.0) ==
    Approx(linear.PositionOf(0.5) - linear.PositionOf(-0.5)));
}

TEST_CASE("All points have a place between the ends of the axis, with room beside them")
{
  for (const bool isLogarithmic : { false, true })
  {
    const ChartScale scale({ 3.0, 0.1, 70.0 }, {}, isLogarithmic);
    CHECK(scale.PositionOf(0.1) > 0.03);
    CHECK(scale.PositionOf(0.1) < 0.1);
    CHECK(scale.PositionOf(70.0) > 0.9);
    CHECK(scale.PositionOf(70.0) < 0.97);
  }
}

TEST_CASE("Only finite values can be shown, and on logarithmic axes only positive ones")
{
  for (const bool isLogarithmic : { false, true })
  {
    CHECK_FALSE(CanShow(NaN, isLogarithmic));
    CHECK_FALSE(CanShow(Infinity, isLogarithmic));
    CHECK_FALSE(CanShow(-Infinity, isLogarithmic));
    CHECK(CanShow(1e-300, isLogarithmic));
    CHECK(CanShow(0.0, isLogarithmic) == !isLogarithmic);
    CHECK(CanShow(-1.0, isLogarithmic) == !isLogarithmic);
  }
  const ChartScale scale({ NaN, 1.0, 0.0, -5.0, Infinity, 100.0 }, { 0.0, NaN }, true);
  const ChartScale same({ 1.0, 100.0 }, {}, true);
  CHECK(scale.PositionOf(7.0) == same.PositionOf(7.0));
}

TEST_CASE("Marks have plain numbers, and stand at their values")
{
  const ChartScale decades({ 0.05, 200.0 }, {}, true);
  CHECK(Labels(decades) == std::vector<std::string>{ "0.1", "1", "10", "100" });
  CHECK(PositionOf(decades, "0.1") == Approx(decades.PositionOf(0.1)));
  CHECK(PositionOf(decades, "100") == Approx(decades.PositionOf(100.0)));
  const ChartScale steps({ 0.06, 4.0 }, {}, true);
  CHECK(Labels(steps) == std::vector<std::string>{ "0.05", "0.1", "0.2", "0.5", "1", "2" });
  const ChartScale linear({ 0.4, 4.0 }, {}, false);
  CHECK(Labels(linear) == std::vector<std::string>{ "0", "1", "2", "3", "4" });
  CHECK(PositionOf(linear, "3") == Approx(linear.PositionOf(3.0)));
  const ChartScale tiny({ 1e-9, 1e-5 }, {}, true);
  CHECK(Labels(tiny) == std::vector<std::string>{ "1e-9", "1e-8", "1e-7", "1e-6", "1e-5" });
}

TEST_CASE("A value alone stands in the middle, whatever it is")
{
  for (const double value : { 1e-320, 1e-300, 0.37, 12.0, 1e300 })
  {
    for (const bool isLogarithmic : { false, true })
    {
      CAPTURE(value, isLogarithmic);
      CHECK(ChartScale({ value, value }, {}, isLogarithmic).PositionOf(value) == Approx(0.5));
    }
  }
  CHECK(ChartScale({ 0.0 }, {}, false).PositionOf(0.0) == Approx(0.5));
}

TEST_CASE("Guides widen an axis by a quarter at most, and make one where there are no points")
{
  const double length = 2.0 / ChartScale({ 1.0, 100.0 }, {}, true).PositionOf(100.0);
  const ChartScale near({ 1.0, 100.0 }, { 0.5, 30.0 }, true);
  CHECK(near.Contains(0.5));
  CHECK(near.PositionOf(100.0) < ChartScale({ 1.0, 100.0 }, {}, true).PositionOf(100.0) + length);
  const ChartScale far({ 1.0, 100.0 }, { 1e-30, 30.0 }, true);
  CHECK(far.GetLowest() == Approx(-0.5 - 0.05 * 2.5));
  CHECK(far.GetHighest() == Approx(2.0 + 0.05 * 2.5));
  CHECK(ChartScale({}, { 10.0, 1000.0 }, true).PositionOf(100.0) == Approx(0.5));
}

TEST_CASE("Marks of any range are few, in order, on the axis, and told apart")
{
  constexpr double huge = std::numeric_limits<double>::max();
  const std::vector<std::vector<double>> ranges{ { 1.0, 10.0 }, { 1e-300, 1e300 }, { 5e-324, huge },
    { 1.0, 1.0 + 1e-7 }, { 1e6 + 0.1, 1e6 + 0.4 }, { 0.999, 1.001 }, { 3.0, 7.0 }, { 9.0, 11.0 },
    { 0.02, 0.9 }, { 7e-5, 3e-4 }, { 1e-12, 1.0 }, { 42.0 }, {} };
  for (auto range : ranges)
  {
    for (const bool isLogarithmic : { false, true })
    {
      for (const int most : { 5, 8 })
      {
        const ChartScale scale(range, {}, isLogarithmic);
        const auto labels = Labels(scale, most);
        CAPTURE(range, isLogarithmic, most, labels);
        CHECK(labels.size() >= 2);
        CHECK(static_cast<int>(labels.size()) <= most + 1);
        CHECK(std::set<std::string>(labels.begin(), labels.end()).size() == labels.size());
        double last = 0.0;
        for (const ChartTick& tick : MakeTicks(scale, most))
        {
          CHECK(tick.Position >= (tick.Label.empty() ? 0.0 : last));
          CHECK(tick.Position <= 1.0);
          last = tick.Label.empty() ? last : tick.Position;
        }
      }
    }
  }
  CHECK(Labels(ChartScale({ -huge, huge }, {}, false)).size() >= 5);
}
