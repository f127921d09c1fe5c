#include "TransferFunctionTable.h"

#include "TransferFunctionIntegrals.h"
#include "TransferFunctionPoints.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int SmallestSize = 1024;
// Between entries a table is checked at this many even positions of each cell.
constexpr int ChecksPerCell = 4;
// Error of the optical depth of one unit distance: relative, or absolute where hardly anything is
// there. 0.5 % of the depth changes no pixel by more than half a grey level of 255.
constexpr double RelativeTolerance = 0.005;
constexpr double AbsoluteTolerance = 2e-4;
// Both opaque within a unit distance: the difference cannot be seen.
constexpr double OpaqueDepth = 4.0;
constexpr double ColorTolerance = 0.004;

std::vector<double> SampleColor(
  const TransferFunctions& functions, double low, double high, int size)
{
  std::vector<double> color(3 * static_cast<size_t>(size), 1.0);
  if (functions.Color && functions.Color->GetSize() > 0 &&
    functions.Color->GetScale() == VTK_CTF_LOG10)
  {
    // A logarithmic function spaces the entries of its own tables by logarithms.
    for (int entry = 0; entry < size; ++entry)
    {
      const double fraction = static_cast<double>(entry) / (size - 1);
      functions.Color->GetColor((1.0 - fraction) * low + fraction * high, &color[3 * entry]);
    }
  }
  else if (functions.Color && functions.Color->GetSize() > 0)
  {
    functions.Color->GetTable(low, high, size, color.data());
  }
  else if (functions.Gray && functions.Gray->GetSize() > 0)
  {
    functions.Gray->GetTable(low, high, size, color.data(), 3);
    for (int entry = 0; entry < size; ++entry)
    {
      color[3 * entry + 1] = color[3 * entry + 2] = color[3 * entry];
    }
  }
  return color;
}

std::vector<double> SampleExtinction(
  const TransferFunctions& functions, double low, double high, int size)
{
  std::vector<double> extinction(size, 0.0);
  if (functions.Opacity->GetSize() > 0)
  {
    functions.Opacity->GetTable(low, high, size, extinction.data());
  }
  for (double& value : extinction)
  {
    value = ComputeExtinction(value, functions.UnitDistance);
  }
  return extinction;
}

bool DepthsAgree(double exact, double interpolated)
{
  const double error = std::abs(exact - interpolated);
  return error <= AbsoluteTolerance + RelativeTolerance * exact ||
    std::min(exact, interpolated) > OpaqueDepth;
}

// Compares the linear interpolation of every ChecksPerCell-th value with the values between.
bool InterpolationHolds(
  const std::vector<double>& extinction, const std::vector<double>& color, double unitDistance)
{
  const size_t last = extinction.size() - 1;
  for (size_t cell = 0; cell < last; cell += ChecksPerCell)
  {
    for (int check = 1; check < ChecksPerCell; ++check)
    {
      const double fraction = static_cast<double>(check) / ChecksPerCell;
      const auto between = [&](const std::vector<double>& values, size_t stride, size_t channel)
      {
        return (1.0 - fraction) * values[stride * cell + channel] +
          fraction * values[stride * (cell + ChecksPerCell) + channel];
      };
      if (!DepthsAgree(
            extinction[cell + check] * unitDistance, between(extinction, 1, 0) * unitDistance))
      {
        return false;
      }
      for (size_t channel = 0; channel < 3; ++channel)
      {
        if (std::abs(color[3 * (cell + check) + channel] - between(color, 3, channel)) >
          ColorTolerance)
        {
          return false;
        }
      }
    }
  }
  return true;
}

void KeepEvery(int stride, int components, const std::vector<double>& from, std::vector<float>& to)
{
  to.clear();
  const size_t size = from.size() / components;
  for (size_t entry = 0; entry < size; entry += stride)
  {
    for (int component = 0; component < components; ++component)
    {
      to.push_back(static_cast<float>(from[components * entry + component]));
    }
  }
}

// What the table's linear interpolation gives at a scalar, as colour and extinction.
std::array<double, 4> Interpolate(const TransferFunctionTable& table, double scalar)
{
  const double last = static_cast<double>(table.Extinction.size() - 1);
  const double entry = std::clamp((scalar - table.Low) / (table.High - table.Low), 0.0, 1.0) * last;
  const auto low = static_cast<size_t>(std::min(std::floor(entry), last - 1.0));
  const double fraction = entry - static_cast<double>(low);
  std::array<double, 4> result;
  for (size_t channel = 0; channel < 3; ++channel)
  {
    result[channel] = (1.0 - fraction) * table.Color[3 * low + channel] +
      fraction * table.Color[3 * (low + 1) + channel];
  }
  result[3] = (1.0 - fraction) * table.Extinction[low] + fraction * table.Extinction[low + 1];
  return result;
}

bool Agrees(const TransferFunctionPoint& exact, const std::array<double, 4>& interpolated,
  double unitDistance)
{
  bool agrees =
    DepthsAgree(ComputeExtinction(exact.ColorAndOpacity[3], 1.0), interpolated[3] * unitDistance);
  for (int channel = 0; channel < 3; ++channel)
  {
    agrees =
      agrees && std::abs(exact.ColorAndOpacity[channel] - interpolated[channel]) <= ColorTolerance;
  }
  return agrees;
}

// Steps and spikes between two entries show at the functions' own points, on either side of them
// that data has.
bool PointsHold(const TransferFunctions& functions, const std::vector<double>& scalars,
  const TransferFunctionTable& table)
{
  return std::all_of(scalars.begin(), scalars.end(),
    [&](double scalar)
    {
      if (scalar < table.Low || scalar > table.High)
      {
        return true;
      }
      const auto interpolated = Interpolate(table, scalar);
      return (scalar <= functions.DataLow ||
               Agrees(GetPoint(functions, scalar, true), interpolated, functions.UnitDistance)) &&
        (scalar >= functions.DataHigh ||
          Agrees(GetPoint(functions, scalar, false), interpolated, functions.UnitDistance));
    });
}

void SetEntry(const TransferFunctions& functions, const TransferFunctionPoint& point, int entry,
  TransferFunctionTable& table)
{
  table.Extinction[entry] =
    static_cast<float>(ComputeExtinction(point.ColorAndOpacity[3], functions.UnitDistance));
  for (int channel = 0; channel < 3; ++channel)
  {
    table.Color[3 * entry + channel] = static_cast<float>(point.ColorAndOpacity[channel]);
  }
}

// Beyond its ends a table is as these are: of a step there, the outer side.
void SetEnds(const TransferFunctions& functions, TransferFunctionTable& table)
{
  if (table.Low > functions.DataLow)
  {
    SetEntry(functions, GetPoint(functions, table.Low, true), 0, table);
  }
  if (table.High < functions.DataHigh)
  {
    SetEntry(functions, GetPoint(functions, table.High, false), table.GetSize() - 1, table);
  }
}

// From the functions' first point to their last, within the data.
void SetRange(const TransferFunctions& functions, const std::vector<double>& scalars,
  TransferFunctionTable& table)
{
  const bool constantBeyond = !scalars.empty() && AreClamped(functions);
  const double first = constantBeyond ? scalars.front() : functions.DataLow;
  const double last = constantBeyond ? scalars.back() : functions.DataHigh;
  table.Low = std::clamp(first, functions.DataLow, functions.DataHigh);
  table.High = std::clamp(last, functions.DataLow, functions.DataHigh);
  if (functions.IntegerData)
  {
    table.Low = std::floor(table.Low);
    table.High = std::ceil(table.High);
  }
  // One cell more than nothing, so that a constant is a table like any other.
  if (table.High <= table.Low)
  {
    table.High = table.Low + std::max(1.0, std::abs(table.Low) * 1e-6);
  }
}

bool FillTable(const TransferFunctions& functions, const std::vector<double>& scalars, int size,
  TransferFunctionTable& table)
{
  const int checked = (size - 1) * ChecksPerCell + 1;
  const std::vector<double> extinction =
    SampleExtinction(functions, table.Low, table.High, checked);
  const std::vector<double> color = SampleColor(functions, table.Low, table.High, checked);
  KeepEvery(ChecksPerCell, 1, extinction, table.Extinction);
  KeepEvery(ChecksPerCell, 3, color, table.Color);
  const bool holds = InterpolationHolds(extinction, color, functions.UnitDistance);
  if (!ArePiecewiseLinear(functions))
  {
    return holds;
  }
  SetEnds(functions, table);
  return holds && PointsHold(functions, scalars, table);
}

// Sizes to try, ascending. Entries of integer data fall on the integers, where points mostly are.
std::vector<int> GetSizes(const TransferFunctionTable& table, bool integerData, int largestSize)
{
  std::vector<int> sizes;
  const double cells = table.High - table.Low;
  if (integerData && cells < largestSize)
  {
    for (double size = cells; size < largestSize; size *= 2.0)
    {
      if (size + 1 >= SmallestSize || 2.0 * size >= largestSize)
      {
        sizes.push_back(static_cast<int>(size) + 1);
      }
    }
    return sizes;
  }
  for (int size = SmallestSize; size <= largestSize; size *= 2)
  {
    sizes.push_back(size);
  }
  return sizes;
}

// Points far outside the data would take the digits of those within.
std::vector<double> ClipToData(
  const TransferFunctions& functions, const std::vector<double>& scalars)
{
  std::vector<double> clipped = { functions.DataLow };
  for (double scalar : scalars)
  {
    if (scalar > functions.DataLow && scalar < functions.DataHigh)
    {
      clipped.push_back(scalar);
    }
  }
  clipped.push_back(functions.DataHigh);
  return clipped;
}

void FillPoints(const std::vector<TransferFunctionPoint>& points, TransferFunctionTable& table)
{
  table.Lookup = TransferFunctionLookup::Points;
  for (const TransferFunctionPoint& point : points)
  {
    table.PointScalars.push_back(point.Scalar - table.Low);
    for (double channel : point.ColorAndOpacity)
    {
      table.PointColors.push_back(static_cast<float>(channel));
    }
  }
}
}

//------------------------------------------------------------------------------
double ComputeExtinction(double opacity, double unitDistance)
{
  constexpr double largestOpacity = 1.0 - 1.0 / 16777216.0;
  return -std::log1p(-std::clamp(opacity, 0.0, largestOpacity)) / unitDistance;
}

//------------------------------------------------------------------------------
TransferFunctionTable MakeTransferFunctionTable(const TransferFunctions& functions, int largestSize)
{
  const std::vector<double> scalars = GetPointScalars(functions);
  TransferFunctionTable table;
  SetRange(functions, scalars, table);
  const std::vector<int> sizes = GetSizes(table, functions.IntegerData, largestSize);
  table.Accurate = std::any_of(sizes.begin(), sizes.end(),
    [&](int size) { return FillTable(functions, scalars, size, table); });
  FillIntegrals(functions, table);
  if (!table.Accurate && ArePiecewiseLinear(functions) && !scalars.empty())
  {
    const auto points = GetPoints(functions, ClipToData(functions, scalars));
    table.Accurate = static_cast<int>(points.size()) <= largestSize;
    if (table.Accurate)
    {
      FillPoints(points, table);
    }
  }
  return table;
}

}
