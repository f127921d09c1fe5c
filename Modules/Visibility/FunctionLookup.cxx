#include "FunctionLookup.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra
{
namespace
{
constexpr int MostCells = 4096;

// Whole numbers fall on the ends of cells where that is possible: functions of such data often bend
// there.
int ChooseNumberOfCells(double range)
{
  const bool whole = range >= 1.0 && range <= MostCells && range == std::floor(range);
  return whole ? MostCells / static_cast<int>(range) * static_cast<int>(range) : MostCells;
}
}

//------------------------------------------------------------------------------
FunctionLookup::FunctionLookup(
  Function function, double low, double high, const std::vector<double>& knots)
  : Exact(std::move(function))
  , Low(low)
  , High(high)
{
  // A single value, or a range beyond what numbers can tell apart or divide.
  if (!(high > low) || !std::isfinite(high - low) || !std::isfinite(MostCells / (high - low)))
  {
    this->Cells.assign(1, Cell{ 0.0f, 0.0f, 0.0f, false });
    return;
  }
  const int count = ChooseNumberOfCells(high - low);
  const double width = (high - low) / count;
  this->CellsPerUnit = count / (high - low);
  for (int cell = 0; cell < count; ++cell)
  {
    this->Cells.push_back(this->MakeCell(low + cell * width, width));
  }
  for (const double knot : knots)
  {
    const double place = (knot - low) * this->CellsPerUnit;
    if (place > 0.0 && place < count && place != std::floor(place))
    {
      this->Cells[static_cast<std::size_t>(place)].Parabola = false;
    }
  }
  this->LastPlace = std::nextafter(static_cast<double>(count), 0.0);
}

//------------------------------------------------------------------------------
FunctionLookup::Cell FunctionLookup::MakeCell(double begin, double width) const
{
  const double first = this->Exact(this->Clamp(begin));
  const double middle = this->Exact(this->Clamp(begin + 0.5 * width));
  const double last = this->Exact(this->Clamp(begin + width));
  const double linear = 4.0 * middle - 3.0 * first - last;
  const double quadratic = 2.0 * (first + last) - 4.0 * middle;
  Cell cell{ static_cast<float>(first), static_cast<float>(linear), static_cast<float>(quadratic),
    true };
  for (const double u : { 0.0, 0.25, 0.5, 0.75, 1.0 })
  {
    const double exact = this->Exact(this->Clamp(begin + u * width));
    const double parabola = cell.Constant + u * (cell.Linear + u * cell.Quadratic);
    const double tolerance = RelativeTolerance * std::abs(exact) + AbsoluteTolerance;
    cell.Parabola = cell.Parabola && std::abs(parabola - exact) <= tolerance;
  }
  return cell;
}

}
