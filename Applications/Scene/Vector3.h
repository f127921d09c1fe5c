/**
 * @file    Vector3.h
 * @brief   the few operations on three numbers that placing cameras and lights takes
 */

#ifndef Vector3_h
#define Vector3_h

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra
{

using Vector3 = std::array<double, 3>;

inline Vector3 Sum(const Vector3& a, const Vector3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Vector3 Difference(const Vector3& a, const Vector3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Vector3 Scaled(const Vector3& a, double factor)
{
  return { a[0] * factor, a[1] * factor, a[2] * factor };
}

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Vector3& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

/// `a` over its length. `a` must not be zero, but may be as small or large as numbers go.
inline Vector3 UnitVector(const Vector3& a)
{
  const double largest = std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
  const Vector3 b = { a[0] / largest, a[1] / largest, a[2] / largest };
  return Scaled(b, 1.0 / Length(b));
}

/// `a` turned about the unit vector `axis` through the origin, counterclockwise seen from its tip.
inline Vector3 Rotated(const Vector3& a, const Vector3& axis, double radians)
{
  const double cosine = std::cos(radians);
  const Vector3 across = Scaled(Cross(axis, a), std::sin(radians));
  const Vector3 along = Scaled(axis, Dot(axis, a) * (1.0 - cosine));
  return Sum(Scaled(a, cosine), Sum(across, along));
}

}

#endif
