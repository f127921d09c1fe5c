#include "GradientOpacityTable.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{

//------------------------------------------------------------------------------
GradientOpacityTable MakeGradientOpacityTable(
  vtkPiecewiseFunction* function, int size, double largestGradient)
{
  GradientOpacityTable table;
  table.Opacity.assign(size, 1.0f);
  const int last = function->GetSize() - 1;
  if (last < 0)
  {
    return table;
  }
  double node[4];
  const auto getNode = [&](int i, int value)
  {
    function->GetNodeValue(i, node);
    return node[value];
  };
  int begin = 0;
  while (begin < last && getNode(begin + 1, 1) == getNode(begin, 1))
  {
    ++begin;
  }
  int end = last;
  while (end > begin && getNode(end - 1, 1) == getNode(end, 1))
  {
    --end;
  }
  table.Low = getNode(begin, 0);
  table.High = std::min(getNode(end, 0), largestGradient);
  if (table.High <= table.Low)
  {
    table.High = table.Low + std::max(1.0, std::abs(table.Low) * 1e-6);
  }
  for (int entry = 0; entry < size; ++entry)
  {
    const double root = static_cast<double>(entry) / (size - 1);
    table.Opacity[entry] =
      static_cast<float>(function->GetValue(table.Low + root * root * (table.High - table.Low)));
  }
  // Beyond its ends a table is as these are: of a step there, the outer side.
  table.Opacity.front() = static_cast<float>(getNode(begin, 1));
  if (table.High >= getNode(end, 0))
  {
    table.Opacity.back() = static_cast<float>(getNode(end, 1));
  }
  return table;
}

//------------------------------------------------------------------------------
double FindLeastVisibleGradient(const GradientOpacityTable& table)
{
  const auto first = std::find_if(
    table.Opacity.begin(), table.Opacity.end(), [](float opacity) { return opacity > 0.0f; });
  if (first == table.Opacity.end())
  {
    return std::numeric_limits<double>::infinity();
  }
  if (first == table.Opacity.begin())
  {
    return 0.0;
  }
  const double root = static_cast<double>(first - table.Opacity.begin() - 1) /
    static_cast<double>(table.Opacity.size() - 1);
  return table.Low + root * root * (table.High - table.Low);
}

}
