#include "TransferFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
PiecewiseLinear<1> MakeClamped(vtkPiecewiseFunction* function)
{
  PiecewiseLinear<1> linear;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    linear.AddPoint(node[0], { std::clamp(node[1], 0.0, 1.0) });
  }
  return linear;
}

/// With one more point where the function passes a value between two points.
PiecewiseLinear<1> SplitAt(const PiecewiseLinear<1>& function, double value)
{
  PiecewiseLinear<1> split;
  const std::vector<double>& levels = function.GetLevels();
  const auto& lines = function.GetLines();
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const auto& line = lines[i];
    const double end = lines[i + 1].AtStart[0];
    if (line.Slope[0] != 0.0 && (line.AtStart[0] - value) * (end - value) < 0.0)
    {
      const double crossing = line.Start + (value - line.AtStart[0]) / line.Slope[0];
      split.AddPoint(std::clamp(crossing, line.Start, levels[i]), { value });
    }
    split.AddPoint(levels[i], { end });
  }
  return split;
}
}

//------------------------------------------------------------------------------
double ExtinctionLine::At(double scalar) const
{
  return -std::log1p(-std::clamp(this->Opacity.At(scalar), 0.0, LargestOpacity)) /
    this->UnitDistance;
}

//------------------------------------------------------------------------------
ExtinctionFunction::ExtinctionFunction(vtkVolumeProperty* property)
  : Opacity(SplitAt(MakeClamped(property->GetScalarOpacity()), LargestOpacity))
{
  for (const auto& line : this->Opacity.GetLines())
  {
    this->Lines.push_back({ line, property->GetScalarOpacityUnitDistance() });
  }
}

//------------------------------------------------------------------------------
bool ExtinctionFunction::IsZero(double low, double high) const
{
  const auto first = this->Lines.begin() + this->Opacity.GetLineNumber(low);
  const auto last = this->Lines.begin() + this->Opacity.GetLineNumber(high);
  return std::all_of(first, last + 1, [](const ExtinctionLine& line) { return line.IsZero(); });
}

//------------------------------------------------------------------------------
PiecewiseLinear<3> MakeColorFunction(vtkVolumeProperty* property)
{
  PiecewiseLinear<3> colors;
  if (property->GetColorChannels() == 1)
  {
    vtkPiecewiseFunction* grey = property->GetGrayTransferFunction();
    for (int i = 0; i < grey->GetSize(); ++i)
    {
      double node[4];
      grey->GetNodeValue(i, node);
      colors.AddPoint(node[0], { node[1], node[1], node[1] });
    }
    return colors;
  }
  vtkColorTransferFunction* function = property->GetRGBTransferFunction();
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    colors.AddPoint(node[0], { node[1], node[2], node[3] });
  }
  return colors;
}

//------------------------------------------------------------------------------
std::optional<PiecewiseLinear<1>> MakeGradientOpacity(vtkVolumeProperty* property)
{
  if (!property->HasGradientOpacity() || property->GetDisableGradientOpacity())
  {
    return std::nullopt;
  }
  auto function = MakeClamped(property->GetGradientOpacity());
  const auto isOne = [](const PiecewiseLinear<1>::Line& line)
  { return line.AtStart[0] == 1.0 && line.Slope[0] == 0.0; };
  const auto& lines = function.GetLines();
  if (std::all_of(lines.begin(), lines.end(), isOne))
  {
    return std::nullopt;
  }
  return function;
}

}
