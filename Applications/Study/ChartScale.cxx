#include "ChartScale.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace penumbra
{
namespace
{
constexpr double Eighth = 0.125;
// What is smaller has not all digits of a double.
constexpr double Smallest = 1e-300;

struct Range
{
  double Lowest;
  double Highest;

  double Length() const { return this->Highest - this->Lowest; }
};

std::optional<Range> FindRange(const ChartScale& scale, const std::vector<double>& values)
{
  std::optional<Range> range;
  for (const double value : values)
  {
    if (CanShow(value, scale.IsLogarithmic()))
    {
      const double measure = scale.Measure(value);
      range = range ? Range{ std::min(range->Lowest, measure), std::max(range->Highest, measure) }
                    : Range{ measure, measure };
    }
  }
  return range;
}

// Where that costs less than half of the axis.
Range BeginAtZero(const Range& range)
{
  return range.Lowest > 0.0 && range.Lowest < 0.5 * range.Highest ? Range{ 0.0, range.Highest }
                                                                  : range;
}

// One value alone, or nearly so, stands in the middle.
Range MakeRoom(const Range& range, bool isLogarithmic)
{
  const double size =
    isLogarithmic ? 1.0 : std::max(std::abs(range.Lowest), std::abs(range.Highest));
  const double leastShare = isLogarithmic ? 0.05 : 1e-9;
  if (range.Length() > std::max(leastShare * size, Smallest))
  {
    return range;
  }
  const double around = size > Smallest ? 0.25 * size : Eighth;
  return { range.Lowest - around, range.Highest + around };
}

Range WidenForGuides(const Range& range, const Range& guides)
{
  constexpr double mostShare = 0.25;
  const double most = mostShare * range.Length();
  return { std::min(range.Lowest, std::max(guides.Lowest, range.Lowest - most)),
    std::max(range.Highest, std::min(guides.Highest, range.Highest + most)) };
}
}

//------------------------------------------------------------------------------
bool CanShow(double value, bool isLogarithmic)
{
  return std::isfinite(value) && (value > 0.0 || !isLogarithmic);
}

//------------------------------------------------------------------------------
ChartScale::ChartScale(
  const std::vector<double>& points, const std::vector<double>& guides, bool isLogarithmic)
  : Logarithmic(isLogarithmic)
{
  constexpr double margin = 0.05;
  const auto ofGuides = FindRange(*this, guides);
  const auto ofPoints = FindRange(*this, points);
  const Range whereThereIsNothing{ this->Measure(1.0), this->Measure(10.0) };
  Range range = ofPoints.value_or(ofGuides.value_or(whereThereIsNothing));
  range = MakeRoom(isLogarithmic ? range : BeginAtZero(range), isLogarithmic);
  if (ofGuides)
  {
    range = WidenForGuides(range, *ofGuides);
  }
  this->Lowest = range.Lowest - margin * range.Length();
  this->Highest = range.Highest + margin * range.Length();
}

//------------------------------------------------------------------------------
double ChartScale::PositionOf(double value) const
{
  return (this->Measure(value) - this->Lowest) / (this->Highest - this->Lowest);
}

//------------------------------------------------------------------------------
bool ChartScale::Contains(double value) const
{
  return CanShow(value, this->Logarithmic) && this->Measure(value) >= this->Lowest &&
    this->Measure(value) <= this->Highest;
}

//------------------------------------------------------------------------------
double ChartScale::Measure(double value) const
{
  return this->Logarithmic ? std::log10(value) : Eighth * value;
}

}
