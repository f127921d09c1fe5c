#include "TransferFunctionPoints.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

namespace penumbra
{
namespace
{
// The first point at or beyond a scalar, or where that is approached from above, beyond it.
template <typename Function>
int FindNextPoint(Function* function, double scalar, bool fromBelow)
{
  double node[6];
  int first = 0;
  int count = function->GetSize();
  while (count > 0)
  {
    const int half = count / 2;
    function->GetNodeValue(first + half, node);
    const bool isBefore = fromBelow ? node[0] < scalar : node[0] <= scalar;
    first += isBefore ? half + 1 : 0;
    count = isBefore ? count - half - 1 : half;
  }
  return first;
}

template <int Components, typename Function>
std::array<double, Components> GetLimit(
  Function* function, double scalar, bool fromBelow, int firstValue)
{
  std::array<double, Components> result{};
  double left[6];
  double right[6];
  const int next = FindNextPoint(function, scalar, fromBelow);
  function->GetNodeValue(std::max(next - 1, 0), left);
  function->GetNodeValue(std::min(next, function->GetSize() - 1), right);
  const double width = right[0] - left[0];
  const double fraction = width > 0.0 ? (scalar - left[0]) / width : 0.0;
  for (int component = 0; component < Components; ++component)
  {
    const int value = firstValue + component;
    result[component] = (1.0 - fraction) * left[value] + fraction * right[value];
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<double> GetPointScalars(const TransferFunctions& functions)
{
  std::vector<double> scalars;
  double values[6];
  for (int node = 0; node < functions.Opacity->GetSize(); ++node)
  {
    functions.Opacity->GetNodeValue(node, values);
    scalars.push_back(values[0]);
  }
  for (int node = 0; functions.Color && node < functions.Color->GetSize(); ++node)
  {
    functions.Color->GetNodeValue(node, values);
    scalars.push_back(values[0]);
  }
  for (int node = 0; functions.Gray && node < functions.Gray->GetSize(); ++node)
  {
    functions.Gray->GetNodeValue(node, values);
    scalars.push_back(values[0]);
  }
  std::sort(scalars.begin(), scalars.end());
  return scalars;
}

//------------------------------------------------------------------------------
bool AreClamped(const TransferFunctions& functions)
{
  return functions.Opacity->GetClamping() && (!functions.Color || functions.Color->GetClamping()) &&
    (!functions.Gray || functions.Gray->GetClamping());
}

//------------------------------------------------------------------------------
bool ArePiecewiseLinear(const TransferFunctions& functions)
{
  const auto isStraight = [](vtkPiecewiseFunction* function)
  {
    double node[4];
    for (int i = 0; i < function->GetSize(); ++i)
    {
      function->GetNodeValue(i, node);
      if (node[2] != 0.5 || node[3] != 0.0)
      {
        return false;
      }
    }
    return !function->GetUseLogScale();
  };
  if (!AreClamped(functions) || !isStraight(functions.Opacity) ||
    (functions.Gray && !isStraight(functions.Gray)))
  {
    return false;
  }
  if (!functions.Color)
  {
    return true;
  }
  double node[6];
  for (int i = 0; i < functions.Color->GetSize(); ++i)
  {
    functions.Color->GetNodeValue(i, node);
    if (node[4] != 0.5 || node[5] != 0.0)
    {
      return false;
    }
  }
  return functions.Color->GetColorSpace() == VTK_CTF_RGB &&
    functions.Color->GetScale() == VTK_CTF_LINEAR;
}

//------------------------------------------------------------------------------
TransferFunctionPoint GetPoint(const TransferFunctions& functions, double scalar, bool fromBelow)
{
  TransferFunctionPoint point{ scalar, { 1.0, 1.0, 1.0, 0.0 } };
  if (functions.Opacity->GetSize() > 0)
  {
    point.ColorAndOpacity[3] = GetLimit<1>(functions.Opacity, scalar, fromBelow, 1)[0];
  }
  if (functions.Color && functions.Color->GetSize() > 0)
  {
    const auto color = GetLimit<3>(functions.Color, scalar, fromBelow, 1);
    std::copy(color.begin(), color.end(), point.ColorAndOpacity.begin());
  }
  else if (functions.Gray && functions.Gray->GetSize() > 0)
  {
    std::fill_n(
      point.ColorAndOpacity.begin(), 3, GetLimit<1>(functions.Gray, scalar, fromBelow, 1)[0]);
  }
  return point;
}

//------------------------------------------------------------------------------
std::vector<TransferFunctionPoint> GetPoints(
  const TransferFunctions& functions, std::vector<double> scalars)
{
  scalars.erase(std::unique(scalars.begin(), scalars.end()), scalars.end());
  std::vector<TransferFunctionPoint> points;
  for (double scalar : scalars)
  {
    const TransferFunctionPoint below = GetPoint(functions, scalar, true);
    const TransferFunctionPoint above = GetPoint(functions, scalar, false);
    points.push_back(below);
    if (above.ColorAndOpacity != below.ColorAndOpacity)
    {
      points.push_back(above);
    }
  }
  return points;
}

}
