/**
 * @file ReflectionTolerance.h
 * @brief How far single precision can lead a lobe of the half vector astray.
 *
 * The shader has cosines of single precision. (N.H)^2 = (N.L + N.V)^2 / (2 + 2 L.V) takes from
 * their rounding a relative error of e about 2^-23 (3 + 1 / |L+V|^2), and the squared slope 1 /
 * (N.H)^2 - 1 the absolute error e / (N.H)^2: that and the slope's own rounding over the variance
 * are the error of the lobe's exponent.
 */
#ifndef ReflectionTolerance_h
#define ReflectionTolerance_h

#include "ReflectionFormulae.h"

#include <algorithm>
#include <cmath>
#include <limits>

constexpr double Epsilon = std::numeric_limits<float>::epsilon();

/// Relative error of (N.H)^2.
inline double ErrorOfHalf(const ReflectionDirections& d)
{
  const Vector sum = Sum(1.0, d.L, 1.0, d.V);
  return Epsilon * (3.0 + 1.0 / Dot(sum, sum));
}

/// Absolute error of a lobe of that value and variance. Below the smallest normal float there are
/// fewer digits.
inline double ErrorOfLobe(const ReflectionDirections& d, double value, double variance)
{
  const double slope = formula::SquaredSlope(d);
  const double exponent = (ErrorOfHalf(d) * (1.0 + slope) + 3.0 * Epsilon * slope) / variance;
  const double factors = 4.0 * ErrorOfHalf(d) + 8.0 * Epsilon;
  return value * std::expm1(std::min(exponent + factors, 700.0)) +
    std::numeric_limits<float>::min();
}

#endif
