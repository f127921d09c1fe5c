#include "ReflectionGeometry.h"

#include <vtkMath.h>

#include <cmath>

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector Sum(double a, const Vector& u, double b, const Vector& v)
{
  return { a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2] };
}

double Length(const Vector& vector)
{
  return std::sqrt(Dot(vector, vector));
}

Vector Normalized(const Vector& vector)
{
  const double length = Length(vector);
  return { vector[0] / length, vector[1] / length, vector[2] / length };
}

Vector AtAngles(double polar, double azimuth)
{
  const double theta = vtkMath::RadiansFromDegrees(polar);
  const double phi = vtkMath::RadiansFromDegrees(azimuth);
  return { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
}

Vector RandomDirection(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  const double x = normal(generator);
  const double y = normal(generator);
  return Normalized({ x, y, normal(generator) });
}

ReflectionDirections RandomDirections(std::mt19937& generator)
{
  ReflectionDirections directions;
  for (Vector* direction : { &directions.N, &directions.L, &directions.V, &directions.P })
  {
    *direction = RandomDirection(generator);
  }
  return directions;
}

ReflectionDirections RandomHighlight(std::mt19937& generator, double slope)
{
  ReflectionDirections directions = RandomDirections(generator);
  if (Dot(directions.N, directions.V) < 0.0)
  {
    directions.V = Sum(-1.0, directions.V, 0.0, directions.V);
  }
  const Vector aside = Normalized(Cross(directions.N, RandomDirection(generator)));
  const double tangent = slope * std::abs(std::normal_distribution<double>()(generator));
  const Vector half = Normalized(Sum(1.0, directions.N, tangent, aside));
  directions.L = Sum(2.0 * Dot(directions.V, half), half, -1.0, directions.V);
  return directions;
}

ReflectionDirections Reversed(const ReflectionDirections& directions)
{
  return { directions.N, directions.V, directions.L, directions.P };
}

shader::ReflectionCosines CosinesOf(const ReflectionDirections& directions)
{
  const auto cosine = [](const Vector& a, const Vector& b)
  { return static_cast<float>(Dot(a, b)); };
  return { cosine(directions.N, directions.L), cosine(directions.N, directions.V),
    cosine(directions.L, directions.V), cosine(directions.P, directions.N),
    cosine(directions.P, directions.L), cosine(directions.P, directions.V) };
}
