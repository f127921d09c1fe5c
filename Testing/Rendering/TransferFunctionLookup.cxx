#include "TransferFunctionLookup.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
Matter LookUpTable(const TransferFunctionTable& table, double scalar)
{
  const int last = table.GetSize() - 1;
  const double position =
    std::clamp((scalar - table.Low) / (table.High - table.Low), 0.0, 1.0) * last;
  const int entry = std::min(static_cast<int>(position), last - 1);
  const double fraction = position - entry;
  const auto mix = [&](const std::vector<float>& values, int stride, int channel)
  {
    return (1.0 - fraction) * values[stride * entry + channel] +
      fraction * values[stride * (entry + 1) + channel];
  };
  return { mix(table.Extinction, 1, 0),
    { mix(table.Color, 3, 0), mix(table.Color, 3, 1), mix(table.Color, 3, 2) } };
}

Matter LookUpPoints(const TransferFunctionTable& table, double scalar, double unitDistance)
{
  const int points = table.GetNumberOfPoints();
  const auto scalarOf = [&](int point) { return table.PointScalars[point]; };
  int next = 0;
  while (next < points && scalarOf(next) <= scalar - table.Low)
  {
    ++next;
  }
  const int from = std::max(next - 1, 0);
  const int to = std::min(next, points - 1);
  const double width = scalarOf(to) - scalarOf(from);
  const double fraction =
    width > 0.0 ? std::clamp((scalar - table.Low - scalarOf(from)) / width, 0.0, 1.0) : 0.0;
  std::array<double, 4> values;
  for (int channel = 0; channel < 4; ++channel)
  {
    values[channel] = (1.0 - fraction) * table.PointColors[4 * from + channel] +
      fraction * table.PointColors[4 * to + channel];
  }
  return { ComputeExtinction(values[3], unitDistance), { values[0], values[1], values[2] } };
}
}

//------------------------------------------------------------------------------
Matter LookUp(const TransferFunctionTable& table, double scalar, double unitDistance)
{
  return table.Lookup == TransferFunctionLookup::Table ? LookUpTable(table, scalar)
                                                       : LookUpPoints(table, scalar, unitDistance);
}

//------------------------------------------------------------------------------
Matter Evaluate(const TransferFunctions& functions, double scalar)
{
  Matter matter;
  matter.extinction =
    ComputeExtinction(functions.Opacity->GetValue(scalar), functions.UnitDistance);
  if (functions.Color)
  {
    functions.Color->GetColor(scalar, matter.color.data());
  }
  else
  {
    matter.color.fill(functions.Gray->GetValue(scalar));
  }
  return matter;
}

//------------------------------------------------------------------------------
OwnedFunctions::OwnedFunctions(std::initializer_list<std::pair<double, double>> opacityPoints)
{
  this->opacity->AllowDuplicateScalarsOn();
  for (const auto& [scalar, value] : opacityPoints)
  {
    this->opacity->AddPoint(scalar, value);
  }
  this->color->AllowDuplicateScalarsOn();
  this->color->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  this->color->AddRGBPoint(255.0, 1.0, 1.0, 1.0);
  this->functions.Opacity = this->opacity;
  this->functions.Color = this->color;
  this->SetRange(0.0, 255.0);
}

//------------------------------------------------------------------------------
void OwnedFunctions::SetRange(double low, double high)
{
  this->functions.DataLow = low;
  this->functions.DataHigh = high;
}

//------------------------------------------------------------------------------
TransferFunctionTable OwnedFunctions::MakeTable() const
{
  return MakeTransferFunctionTable(this->functions, 8192);
}

}
