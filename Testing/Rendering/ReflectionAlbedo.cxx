#include "ReflectionAlbedo.h"

#include <vtkMath.h>

#include <cmath>

namespace
{
// Of the lattice on the unit square. The second coordinate goes on by the golden ratio.
double First(int point, int points)
{
  return (point + 0.5) / points;
}

double Second(int point)
{
  const double turns = point * 0.61803398874989485;
  return turns - std::floor(turns);
}

Vector FromCosine(double cosine, double azimuth)
{
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return { sine * std::cos(azimuth), sine * std::sin(azimuth), cosine };
}
}

//------------------------------------------------------------------------------
double HemisphereIntegral(const Reflection& reflection, const Vector& view, int points)
{
  ReflectionDirections directions;
  directions.V = view;
  double sum = 0.0;
  for (int point = 0; point < points; ++point)
  {
    // Equal heights have equal areas on the sphere.
    directions.L = FromCosine(First(point, points), 2.0 * vtkMath::Pi() * Second(point));
    sum += reflection(CosinesOf(directions));
  }
  return 2.0 * vtkMath::Pi() * sum / points;
}

//------------------------------------------------------------------------------
double HalfVectorIntegral(
  const Reflection& reflection, const Vector& view, double slope, int points)
{
  ReflectionDirections directions;
  directions.V = view;
  double sum = 0.0;
  for (int point = 0; point < points; ++point)
  {
    const double u = First(point, points);
    const double squaredTangent = slope * slope * u / (1.0 - u);
    const double cosine = 1.0 / std::sqrt(1.0 + squaredTangent);
    const Vector half = FromCosine(cosine, 2.0 * vtkMath::Pi() * Second(point));
    const double toEye = Dot(half, view);
    directions.L = Sum(2.0 * toEye, half, -1.0, view);
    if (toEye > 0.0 && directions.L[2] > 0.0)
    {
      // Of half vectors there are cos^3 / 2 per square of the slope and radian, and of lights 4 V.H
      // per half vector.
      const double halves = vtkMath::Pi() * std::pow(cosine, 3) * std::pow(slope / (1.0 - u), 2);
      sum += reflection(CosinesOf(directions)) * 4.0 * toEye * halves;
    }
  }
  return sum / points;
}

//------------------------------------------------------------------------------
double MirrorIntegral(const Reflection& reflection, const Vector& view, double power, int points)
{
  ReflectionDirections directions;
  directions.V = view;
  const Vector mirrored = { -view[0], -view[1], view[2] };
  const Vector aside = { mirrored[2], 0.0, -mirrored[0] }; // views are in the plane of x and z
  const Vector upright = Cross(mirrored, aside);
  double sum = 0.0;
  for (int point = 0; point < points; ++point)
  {
    const double cosine = std::pow(First(point, points), 1.0 / (power + 1.0));
    const Vector about = FromCosine(cosine, 2.0 * vtkMath::Pi() * Second(point));
    directions.L = Sum(1.0, Sum(about[0], aside, about[1], upright), about[2], mirrored);
    sum += reflection(CosinesOf(directions)) / std::pow(cosine, power);
  }
  return 2.0 * vtkMath::Pi() / (power + 1.0) * sum / points;
}
