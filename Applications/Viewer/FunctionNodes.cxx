#include "FunctionNodes.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
FunctionPoints<1> PointsOf(vtkPiecewiseFunction* function)
{
  FunctionPoints<1> points;
  double node[4];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], std::clamp(node[1], 0.0, 1.0) });
  }
  return points;
}

//------------------------------------------------------------------------------
FunctionPoints<3> PointsOf(vtkColorTransferFunction* function)
{
  FunctionPoints<3> points;
  double node[6];
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    points.push_back({ node[0], std::clamp(node[1], 0.0, 1.0), std::clamp(node[2], 0.0, 1.0),
      std::clamp(node[3], 0.0, 1.0) });
  }
  return points;
}

//------------------------------------------------------------------------------
void ShowPoints(const FunctionPoints<1>& points, vtkPiecewiseFunction* function)
{
  if (PointsOf(function) != points)
  {
    function->RemoveAllPoints();
    for (const auto& [x, y] : points)
    {
      function->AddPoint(x, y);
    }
  }
}

//------------------------------------------------------------------------------
void ShowPoints(const FunctionPoints<3>& points, vtkColorTransferFunction* function)
{
  if (PointsOf(function) != points)
  {
    function->RemoveAllPoints();
    for (const auto& [x, red, green, blue] : points)
    {
      function->AddRGBPoint(x, red, green, blue);
    }
  }
}

}
