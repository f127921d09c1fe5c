#include "ChartTicks.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace penumbra
{
namespace
{
using Values = std::vector<double>;

constexpr int FewestLabels = 3;
// Within which the multiples of a power of ten are told apart, and within which the powers are.
constexpr int MostFineDecades = 6;
constexpr int MostDecades = 40;

int CountOf(const Values& values)
{
  return static_cast<int>(values.size());
}

// Each power of ten whose exponent is a multiple of `every`, times each of the factors.
Values PowersOfTen(const ChartScale& scale, int every, const std::vector<int>& factors)
{
  const int first = static_cast<int>(std::floor(scale.GetLowest() / every)) * every;
  Values values;
  for (int exponent = first; exponent <= scale.GetHighest(); exponent += every)
  {
    for (const int factor : factors)
    {
      const double value = factor * std::pow(10.0, exponent);
      if (scale.Contains(value))
      {
        values.push_back(value);
      }
    }
  }
  return values;
}

// 1, 2 or 5 times a power of ten.
double RoundStepFrom(double least)
{
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * power >= least)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

Values EqualSteps(const ChartScale& scale, int most)
{
  // In eighths, as the scale has them, the largest numbers have finite differences.
  const auto inEighths = [&scale](double measure)
  { return scale.IsLogarithmic() ? std::pow(10.0, measure) / 8.0 : measure; };
  const double lowest = inEighths(scale.GetLowest());
  const double highest = inEighths(scale.GetHighest());
  const double step = RoundStepFrom((highest - lowest) / most * 8.0);
  Values values;
  for (double i = std::ceil(lowest / (step / 8.0)); i <= highest / (step / 8.0); ++i)
  {
    const double value = i * step + 0.0; // no negative zero
    if (scale.Contains(value))
    {
      values.push_back(value);
    }
  }
  return values;
}

struct TickValues
{
  Values Labelled;
  Values Between;
};

TickValues ChooseOnLogarithmic(const ChartScale& scale, int most)
{
  const double length = scale.GetHighest() - scale.GetLowest();
  const int every = static_cast<int>(RoundStepFrom(std::floor(length / most) + 1.0));
  const Values decades = PowersOfTen(scale, every, { 1 });
  if (length > MostFineDecades)
  {
    return { decades, length > MostDecades ? Values{} : PowersOfTen(scale, 1, { 1 }) };
  }
  const Values multiples = PowersOfTen(scale, 1, { 1, 2, 3, 4, 5, 6, 7, 8, 9 });
  if (CountOf(decades) >= FewestLabels)
  {
    return { decades, multiples };
  }
  for (const std::vector<int>& factors : { std::vector<int>{ 1, 2, 5 }, { 1, 3 } })
  {
    const Values values = PowersOfTen(scale, 1, factors);
    if (CountOf(values) >= FewestLabels && CountOf(values) <= most)
    {
      return { values, multiples };
    }
  }
  return length < 1.0 ? TickValues{ EqualSteps(scale, most), {} }
                      : TickValues{ decades, multiples };
}

// With as many digits as tell the values apart.
std::string NumberInWords(double value, int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  std::string number = text.str();
  const auto exponent = number.find('e');
  if (exponent == std::string::npos)
  {
    return number;
  }
  const std::string sign = number[exponent + 1] == '-' ? "-" : "";
  return number.substr(0, exponent + 1) + sign +
    number.substr(number.find_first_not_of("+-0", exponent + 1));
}

int DigitsFor(const Values& values, int usual)
{
  constexpr int most = 15;
  if (values.size() < 2)
  {
    return usual;
  }
  const double last = values[values.size() - 1];
  const double lastButOne = values[values.size() - 2];
  const double largest = std::max(std::abs(values.front()), std::abs(last));
  const double steps = largest / 8.0 / (last / 8.0 - lastButOne / 8.0);
  return std::clamp(static_cast<int>(std::ceil(std::log10(steps))) + 1, usual, most);
}
}

//------------------------------------------------------------------------------
std::vector<ChartTick> MakeTicks(const ChartScale& scale, int mostLabels)
{
  const TickValues values = scale.IsLogarithmic() ? ChooseOnLogarithmic(scale, mostLabels)
                                                  : TickValues{ EqualSteps(scale, mostLabels), {} };
  const int digits = DigitsFor(values.Labelled, scale.IsLogarithmic() ? 5 : 6);
  std::vector<ChartTick> ticks;
  for (const double value : values.Labelled)
  {
    ticks.push_back({ scale.PositionOf(value), NumberInWords(value, digits) });
  }
  for (const double value : values.Between)
  {
    ticks.push_back({ scale.PositionOf(value), "" });
  }
  return ticks;
}

}
