#include "TransferFunctionIntegrals.h"

#include "TransferFunctionPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace penumbra
{
namespace
{
// Extinction, and its products with the colour.
using Weighted = std::array<double, 4>;

Weighted WeighPoint(const TransferFunctions& functions, double scalar, bool fromBelow)
{
  const auto point = GetPoint(functions, scalar, fromBelow).ColorAndOpacity;
  const double extinction = ComputeExtinction(point[3], functions.UnitDistance);
  return { extinction, extinction * point[0], extinction * point[1], extinction * point[2] };
}

Weighted WeighEntry(const TransferFunctionTable& table, double entry)
{
  const auto low = static_cast<std::size_t>(entry);
  const std::size_t high = std::min(low + 1, table.Extinction.size() - 1);
  const double part = entry - static_cast<double>(low);
  const auto between = [part](double from, double to) { return from + part * (to - from); };
  const double extinction = between(table.Extinction[low], table.Extinction[high]);
  Weighted weighted = { extinction };
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    weighted[1 + channel] =
      extinction * between(table.Color[3 * low + channel], table.Color[3 * high + channel]);
  }
  return weighted;
}

Weighted Simpson(const Weighted& from, const Weighted& middle, const Weighted& to, double length)
{
  Weighted integral;
  for (std::size_t i = 0; i < integral.size(); ++i)
  {
    integral[i] = length * (from[i] + 4.0 * middle[i] + to[i]) / 6.0;
  }
  return integral;
}

// A cell of the table, exactly where points of the functions lie within it.
Weighted IntegrateCell(const TransferFunctions& functions, const TransferFunctionTable& table,
  std::size_t cell, const std::vector<double>& pointsWithin)
{
  const auto entry = static_cast<double>(cell);
  const double length = 1.0 / static_cast<double>(table.Extinction.size());
  if (pointsWithin.empty())
  {
    return Simpson(WeighEntry(table, entry), WeighEntry(table, entry + 0.5),
      WeighEntry(table, entry + 1.0), length);
  }
  const double scalarsPerCell =
    (table.High - table.Low) / static_cast<double>(table.Extinction.size() - 1);
  std::vector<double> ends = { table.Low + entry * scalarsPerCell };
  ends.insert(ends.end(), pointsWithin.begin(), pointsWithin.end());
  ends.push_back(table.Low + (entry + 1.0) * scalarsPerCell);
  Weighted sum{};
  for (std::size_t end = 0; end + 1 < ends.size(); ++end)
  {
    const double middle = 0.5 * (ends[end] + ends[end + 1]);
    const Weighted piece = Simpson(WeighPoint(functions, ends[end], false),
      WeighPoint(functions, middle, true), WeighPoint(functions, ends[end + 1], true),
      length * (ends[end + 1] - ends[end]) / scalarsPerCell);
    std::transform(sum.begin(), sum.end(), piece.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

std::vector<double> GetPointsWithin(const std::vector<double>& ascending, double low, double high)
{
  const auto begin = std::upper_bound(ascending.begin(), ascending.end(), low);
  return { begin, std::lower_bound(begin, ascending.end(), high) };
}

// The integral of extinction up to an entry, in extinctions times entries. Beyond its ends a table
// is as these are.
double IntegrateTo(const TransferFunctionTable& table, double entry)
{
  const double last = static_cast<double>(table.Extinction.size() - 1);
  const double within = std::clamp(entry, 0.0, last);
  const auto low = static_cast<std::size_t>(within);
  const std::size_t high = std::min(low + 1, table.Extinction.size() - 1);
  const double part = within - static_cast<double>(low);
  const double integral = (1.0 - part) * table.ExtinctionIntegral[low] +
    part * static_cast<double>(table.ExtinctionIntegral[high]);
  return integral * (last + 1.0) + (entry - within) * table.Extinction[low];
}

// Whether the extinction at an entry is far from the mean over the entries within a distance: by
// more than a tenth of an optical depth per step.
bool IsSteepAt(const TransferFunctions& functions, const TransferFunctionTable& table, double entry,
  double distance)
{
  constexpr double depth = 0.1;
  constexpr double share = 0.25;
  const double mean =
    (IntegrateTo(table, entry + distance) - IntegrateTo(table, entry - distance)) /
    (2.0 * distance);
  const double last = static_cast<double>(table.Extinction.size() - 1);
  const double exact = table.Extinction[static_cast<std::size_t>(std::clamp(entry, 0.0, last))];
  const double difference = std::abs(mean - exact);
  return difference * functions.Step > depth && difference > share * std::max(mean, exact);
}

// Whether it is so for some part of the data's range as wide as what a step passes at an edge.
bool IsSteep(const TransferFunctions& functions, const TransferFunctionTable& table)
{
  constexpr double partOfRange = 1.0 / 64.0;
  const double cells = static_cast<double>(table.Extinction.size() - 1);
  const double distance =
    0.5 * partOfRange * (functions.DataHigh - functions.DataLow) * cells / (table.High - table.Low);
  for (double entry = 0.0; distance > 0.0 && entry <= cells; ++entry)
  {
    if (IsSteepAt(functions, table, entry, distance))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
void FillIntegrals(const TransferFunctions& functions, TransferFunctionTable& table)
{
  const std::vector<double> points =
    ArePiecewiseLinear(functions) ? GetPointScalars(functions) : std::vector<double>{};
  const double scalarsPerCell =
    (table.High - table.Low) / static_cast<double>(table.Extinction.size() - 1);
  Weighted sum{};
  table.ExtinctionIntegral = { 0.0f };
  table.ColorIntegral.assign(3, 0.0f);
  for (std::size_t cell = 0; cell + 1 < table.Extinction.size(); ++cell)
  {
    const double low = table.Low + static_cast<double>(cell) * scalarsPerCell;
    const Weighted integral =
      IntegrateCell(functions, table, cell, GetPointsWithin(points, low, low + scalarsPerCell));
    std::transform(sum.begin(), sum.end(), integral.begin(), sum.begin(), std::plus<>());
    table.ExtinctionIntegral.push_back(static_cast<float>(sum[0]));
    std::transform(sum.begin() + 1, sum.end(), std::back_inserter(table.ColorIntegral),
      [](double value) { return static_cast<float>(value); });
  }
  table.Steep = IsSteep(functions, table);
}

}
