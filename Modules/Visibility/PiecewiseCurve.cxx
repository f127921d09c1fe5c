#include "PiecewiseCurve.h"

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
PiecewiseCurve::PiecewiseCurve(vtkPiecewiseFunction* function)
  : Straight(!function->GetUseLogScale())
{
  // Its DeepCopy() loses one of two points at the same scalar.
  this->Function->AllowDuplicateScalarsOn();
  this->Function->SetClamping(function->GetClamping());
  this->Function->SetUseLogScale(function->GetUseLogScale());
  for (int point = 0; point < function->GetSize(); ++point)
  {
    double node[4];
    function->GetNodeValue(point, node);
    this->Function->AddPoint(node[0], node[1], node[2], node[3]);
    this->Points.push_back({ node[0], node[1] });
    this->Straight = this->Straight && node[2] == 0.5 && node[3] == 0.0;
  }
}

//------------------------------------------------------------------------------
std::vector<PiecewiseCurve::Point>::const_iterator PiecewiseCurve::FindNotBelow(double x) const
{
  return std::lower_bound(this->Points.begin(), this->Points.end(), x,
    [](const Point& point, double value) { return point.X < value; });
}

//------------------------------------------------------------------------------
double PiecewiseCurve::GetValue(double x) const
{
  if (!this->Straight)
  {
    return this->Function->GetValue(x);
  }
  const auto right = this->FindNotBelow(x);
  if (right == this->Points.end() || right == this->Points.begin())
  {
    const bool clamped = this->Function->GetClamping() != 0 && !this->Points.empty();
    return !clamped ? 0.0 : right == this->Points.end() ? this->Points.back().Y : right->Y;
  }
  if (x == right->X)
  {
    return right->Y;
  }
  const auto left = right - 1;
  return left->Y + (right->Y - left->Y) * ((x - left->X) / (right->X - left->X));
}

//------------------------------------------------------------------------------
// Between two points every curve of VTK's keeps between their values.
bool PiecewiseCurve::IsZeroBetween(double low, double high) const
{
  if (this->GetValue(low) > 0.0 || this->GetValue(high) > 0.0)
  {
    return false;
  }
  const auto isZero = [](const Point& point) { return point.Y <= 0.0; };
  auto last = this->FindNotBelow(high);
  while (last != this->Points.end() && last->X == high)
  {
    ++last;
  }
  return std::all_of(this->FindNotBelow(low), last, isZero);
}

//------------------------------------------------------------------------------
std::vector<double> PiecewiseCurve::GetKnots() const
{
  std::vector<double> knots;
  for (const Point& point : this->Points)
  {
    knots.push_back(point.X);
  }
  return knots;
}

}
