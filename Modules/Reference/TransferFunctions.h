/**
 * @file    TransferFunctions.h
 * @brief   a volume's property as functions of the scalar value
 */

#ifndef TransferFunctions_h
#define TransferFunctions_h

#include "PiecewiseLinear.h"

#include <optional>

class vtkVolumeProperty;

namespace penumbra::reference
{

/// The largest opacity that matter has.
constexpr double LargestOpacity = 1.0 - 1.0 / 16777216.0;

/// Between two neighbouring points: s = -ln(1 - min(opacity, LargestOpacity)) / unit distance.
struct ExtinctionLine
{
  PiecewiseLinear<1>::Line Opacity;
  double UnitDistance = 1.0;

  double At(double scalar) const;
  bool IsZero() const { return this->Opacity.AtStart[0] == 0.0 && this->Opacity.Slope[0] == 0.0; }
};

/**
 * The extinction per length in the volume's own frame. Its levels are the points of the opacity
 * function and where that reaches LargestOpacity.
 */
class ExtinctionFunction
{
public:
  ExtinctionFunction() = default;
  explicit ExtinctionFunction(vtkVolumeProperty* property);

  const ExtinctionLine& GetLine(double scalar) const
  {
    return this->Lines[this->Opacity.GetLineNumber(scalar)];
  }
  const std::vector<double>& GetLevels() const { return this->Opacity.GetLevels(); }

  /// Whether there is none at all of scalars from `low` to `high`.
  bool IsZero(double low, double high) const;

private:
  PiecewiseLinear<1> Opacity;
  std::vector<ExtinctionLine> Lines;
};

/// Red, green and blue.
PiecewiseLinear<3> MakeColorFunction(vtkVolumeProperty* property);

/// By the magnitude of the gradient in scalar units per mean voxel, 0 to 1. Empty: 1 everywhere.
std::optional<PiecewiseLinear<1>> MakeGradientOpacity(vtkVolumeProperty* property);

}

#endif
