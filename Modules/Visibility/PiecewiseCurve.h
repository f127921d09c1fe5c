/**
 * @file    PiecewiseCurve.h
 * @brief   a vtkPiecewiseFunction as it was at one moment, for many threads
 *
 * Straight lines between points are found by bisection among a copy of the points; any other curve
 * (midpoints, sharpness, logarithmic) asks a copy of the function. At a step, two points of one
 * scalar, the value is that from below, as VTK's.
 */

#ifndef PiecewiseCurve_h
#define PiecewiseCurve_h

#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <vector>

namespace penumbra
{

class PiecewiseCurve
{
public:
  explicit PiecewiseCurve(vtkPiecewiseFunction* function);

  double GetValue(double x) const;
  /// Whether no value between low and high, both included, is above 0.
  bool IsZeroBetween(double low, double high) const;
  /// Where the curve has its points, ascending.
  std::vector<double> GetKnots() const;

private:
  struct Point
  {
    double X;
    double Y;
  };

  std::vector<Point>::const_iterator FindNotBelow(double x) const;

  vtkNew<vtkPiecewiseFunction> Function;
  std::vector<Point> Points;
  bool Straight = true;
};

}

#endif
