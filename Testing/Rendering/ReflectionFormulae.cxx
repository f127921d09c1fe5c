#include "ReflectionFormulae.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace formula
{
namespace
{
double Square(double value)
{
  return value * value;
}

Vector Half(const ReflectionDirections& d)
{
  return Normalized(Sum(1.0, d.L, 1.0, d.V));
}

bool Lit(const ReflectionDirections& d)
{
  return Dot(d.N, d.L) > 0.0;
}

bool Seen(const ReflectionDirections& d)
{
  return Dot(d.N, d.V) > 0.0;
}

// Angle from one direction's projection on the tangent plane to another's.
double Azimuth(const Vector& normal, const Vector& from, const Vector& to)
{
  const Vector x = Normalized(Sum(1.0, from, -Dot(from, normal), normal));
  const Vector y = Cross(normal, x);
  return std::atan2(Dot(to, y), Dot(to, x));
}

double GeometricAttenuation(const ReflectionDirections& d)
{
  const Vector half = Half(d);
  const double masked = 2.0 * Dot(d.N, half) * Dot(d.N, d.V) / Dot(d.V, half);
  const double shadowed = 2.0 * Dot(d.N, half) * Dot(d.N, d.L) / Dot(d.V, half);
  return std::min({ 1.0, masked, shadowed });
}

double CookTorrance(const ReflectionDirections& d, double distribution)
{
  return distribution * GeometricAttenuation(d) / (vtkMath::Pi() * Dot(d.N, d.V));
}
}

double Angle(const Vector& a, const Vector& b)
{
  return std::atan2(Length(Cross(a, b)), Dot(a, b));
}

double SquaredSlope(const ReflectionDirections& d)
{
  return Square(std::tan(Angle(d.N, Half(d))));
}

double Lambert(const ReflectionDirections& d)
{
  return std::max(std::cos(Angle(d.N, d.L)), 0.0);
}

double OrenNayar(const ReflectionDirections& d, double roughness)
{
  if (!Lit(d))
  {
    return 0.0;
  }
  const double toLight = Angle(d.N, d.L);
  const double toEye = std::min(Angle(d.N, d.V), 0.5 * vtkMath::Pi());
  const double variance = Square(roughness);
  const double a = 1.0 - 0.5 * variance / (variance + 0.33);
  const double b = 0.45 * variance / (variance + 0.09);
  const double facing = std::max(std::cos(Azimuth(d.N, d.L, d.V)), 0.0);
  return std::cos(toLight) *
    (a + b * facing * std::sin(std::max(toLight, toEye)) * std::tan(std::min(toLight, toEye)));
}

double Phong(const ReflectionDirections& d, double power)
{
  const double cosine = Dot(Sum(2.0 * Dot(d.N, d.L), d.N, -1.0, d.L), d.V);
  return Lit(d) && cosine > 0.0 ? std::pow(cosine, power) : 0.0;
}

double BlinnPhong(const ReflectionDirections& d, double power)
{
  return Lit(d) && Seen(d) ? std::pow(std::cos(Angle(d.N, Half(d))), power) : 0.0;
}

double Ward(const ReflectionDirections& d, double roughness)
{
  if (!Lit(d) || !Seen(d))
  {
    return 0.0;
  }
  return std::sqrt(Dot(d.N, d.L) / Dot(d.N, d.V)) * std::exp(-SquaredSlope(d) / Square(roughness)) /
    (4.0 * vtkMath::Pi() * Square(roughness));
}

double WardAnisotropic(const ReflectionDirections& d, double along, double across)
{
  if (!Lit(d) || !Seen(d))
  {
    return 0.0;
  }
  const double phi = Azimuth(d.N, d.P, Half(d));
  const double weight = Square(std::cos(phi) / along) + Square(std::sin(phi) / across);
  return std::sqrt(Dot(d.N, d.L) / Dot(d.N, d.V)) * std::exp(-SquaredSlope(d) * weight) /
    (4.0 * vtkMath::Pi() * along * across);
}

double CookTorranceBeckmann(const ReflectionDirections& d, double slope)
{
  if (!Lit(d) || !Seen(d))
  {
    return 0.0;
  }
  const double gamma = Angle(d.N, Half(d));
  return CookTorrance(
    d, std::exp(-Square(std::tan(gamma) / slope)) / (Square(slope) * std::pow(std::cos(gamma), 4)));
}

double CookTorranceGaussian(const ReflectionDirections& d, double slope, double constant)
{
  if (!Lit(d) || !Seen(d))
  {
    return 0.0;
  }
  return CookTorrance(d, constant * std::exp(-Square(Angle(d.N, Half(d)) / slope)));
}

double Fresnel(double angle, double n)
{
  const double sine = std::sin(angle) / n;
  if (sine >= 1.0)
  {
    return 1.0;
  }
  const double inside = std::sqrt(1.0 - sine * sine);
  const double outside = std::cos(angle);
  const double perpendicular = (outside - n * inside) / (outside + n * inside);
  const double parallel = (n * outside - inside) / (n * outside + inside);
  return 0.5 * (Square(perpendicular) + Square(parallel));
}
}
