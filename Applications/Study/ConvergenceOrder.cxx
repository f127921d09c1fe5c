#include "ConvergenceOrder.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// Of values that are rounded to whole grey levels, spread evenly between them.
const double LargestRounding = 1.0 / std::sqrt(12.0);
constexpr double WellAbove = 2.0;

bool AreAlike(const ErrorRow& left, const ErrorRow& right)
{
  return left.Scene == right.Scene && left.Variant == right.Variant;
}

const ErrorRow& FinestLike(const std::vector<ErrorRow>& rows, const ErrorRow& row)
{
  const ErrorRow* finest = &row;
  for (const ErrorRow& other : rows)
  {
    finest = AreAlike(row, other) && other.Step < finest->Step ? &other : finest;
  }
  return *finest;
}

// The next larger step.
const ErrorRow* CoarserThan(const std::vector<ErrorRow>& rows, const ErrorRow& row)
{
  const ErrorRow* coarser = nullptr;
  for (const ErrorRow& other : rows)
  {
    const bool isCoarser = AreAlike(row, other) && other.Step > row.Step;
    coarser = isCoarser && (!coarser || other.Step < coarser->Step) ? &other : coarser;
  }
  return coarser;
}

double SquareWithout(const ErrorRow& row, double rounding)
{
  return row.Error.RootMeanSquare * row.Error.RootMeanSquare - rounding * rounding;
}
}

//------------------------------------------------------------------------------
std::optional<double> OrderAt(const std::vector<ErrorRow>& rows, std::size_t row)
{
  const ErrorRow& fine = rows[row];
  const ErrorRow* coarse = CoarserThan(rows, fine);
  const double rounding = std::min(FinestLike(rows, fine).Error.RootMeanSquare, LargestRounding);
  const double least = WellAbove * rounding;
  if (!coarse || fine.Error.RootMeanSquare < least || coarse->Error.RootMeanSquare < least)
  {
    return std::nullopt;
  }
  const double ratio = SquareWithout(*coarse, rounding) / SquareWithout(fine, rounding);
  return 0.5 * std::log(ratio) / std::log(coarse->Step / fine.Step);
}

//------------------------------------------------------------------------------
std::optional<double> ObservedOrder(
  const std::vector<ErrorRow>& rows, const std::string& scene, const std::string& variant)
{
  std::optional<double> order;
  double finest = 0.0;
  for (std::size_t at = 0; at < rows.size(); ++at)
  {
    const bool isOurs = rows[at].Scene == scene && rows[at].Variant == variant;
    const auto found = isOurs ? OrderAt(rows, at) : std::nullopt;
    if (found && (!order || rows[at].Step < finest))
    {
      order = found;
      finest = rows[at].Step;
    }
  }
  return order;
}

}
