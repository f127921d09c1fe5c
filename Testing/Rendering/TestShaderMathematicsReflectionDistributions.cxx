#include "Catch.h"
#include "ReflectionTolerance.h"

#include <vtkMath.h>

#include <functional>

namespace
{
// Integral over t = tan^2 from 0 to infinity, dense where it is up to the variance.
double IntegralOverSquaredSlopes(double variance, const std::function<double(double)>& integrand)
{
  constexpr int steps = 4000;
  double sum = 0.0;
  for (int step = 0; step < steps; ++step)
  {
    const double u = (step + 0.5) / steps;
    sum += integrand(variance * u / (1.0 - u)) * variance / ((1.0 - u) * (1.0 - u));
  }
  return sum / steps;
}

// Light and eye together, so that the half vector is there too.
shader::ReflectionCosines Retroreflected(double squaredSlope, double azimuth)
{
  const double cosine = 1.0 / std::sqrt(1.0 + squaredSlope);
  const double sine = std::sqrt(squaredSlope) * cosine;
  const auto height = static_cast<float>(cosine);
  const auto along = static_cast<float>(sine * std::cos(azimuth));
  return { height, height, 1.0f, 0.0f, along, along };
}
}

TEST_CASE("Beckmann's facets cover the surface that they stand on")
{
  for (const double m : { 0.03, 0.1, 0.3, 1.0, 3.0 })
  {
    // D N.H dw = pi D d(cos^2), and d(cos^2) = cos^4 d(tan^2).
    const double covered = IntegralOverSquaredSlopes(m * m,
      [=](double t)
      {
        const double square = 1.0 / (1.0 + t);
        return shader::cookTorrance::beckmannDistribution(
                 static_cast<float>(square), static_cast<float>(m)) *
          square * square;
      });
    // The model's 1 / pi is in specularReflection. 1 - cos^2 has an error of 2^-24, relative to
    // m^2.
    CHECK(covered == Approx(1.0).margin(1e-5 + 0.5 * Epsilon / (m * m)));
  }
}

TEST_CASE("Ward's slopes are distributed normally: their shares add up to 1")
{
  for (const double roughness : { 0.03, 0.1, 0.3, 1.0, 3.0 })
  {
    const auto parameter = static_cast<float>(roughness);
    // Without the 1/4 of half vectors per directions of light; slopes have the area pi d(tan^2).
    const double sum = IntegralOverSquaredSlopes(roughness * roughness,
      [=](double t)
      {
        return 4.0 * vtkMath::Pi() *
          shader::ward::specularReflection(Retroreflected(t, 0.0), { parameter });
      });
    CHECK(sum == Approx(1.0).margin(1e-5 + Epsilon / (roughness * roughness)));
  }
}

TEST_CASE("Ward's slopes along and across are distributed normally: their shares add up to 1")
{
  const float roughnesses[][2] = { { 0.1f, 0.5f }, { 0.5f, 0.1f }, { 1.0f, 0.3f } };
  for (const auto& roughness : roughnesses)
  {
    constexpr int azimuths = 64; // of a periodic function: exact to 1e-6
    double sum = 0.0;
    for (int azimuth = 0; azimuth < azimuths; ++azimuth)
    {
      const double phi = 2.0 * vtkMath::Pi() * azimuth / azimuths;
      sum += IntegralOverSquaredSlopes(roughness[0] * roughness[1],
        [&](double t)
        {
          return 4.0 * vtkMath::Pi() *
            shader::wardAnisotropic::specularReflection(
              Retroreflected(t, phi), { roughness[0], roughness[1] });
        });
    }
    CHECK(sum / azimuths == Approx(1.0).margin(1e-4));
  }
}

TEST_CASE("The Gaussian distribution is Beckmann's for small slopes, up to its constant")
{
  for (const double m : { 0.02, 0.05, 0.1 })
  {
    const auto slope = static_cast<float>(m);
    for (double angle = 0.0; angle <= 2.0 * m; angle += 0.1 * m)
    {
      const auto square = static_cast<float>(std::cos(angle) * std::cos(angle));
      const double beckmann = shader::cookTorrance::beckmannDistribution(square, slope);
      const double gaussian =
        shader::cookTorrance::gaussianDistribution(square, slope, 1.0f / (slope * slope));
      // tan^2 - angle^2 is 2/3 angle^4, over m^2; 1 / cos^4 is 1 + 2 angle^2: up to 19 m^2
      // together.
      CHECK(gaussian == Approx(beckmann).epsilon(20.0 * m * m + 4.0 * Epsilon / (m * m)));
    }
  }
}

TEST_CASE("The Gaussian distribution falls from its constant with the angle's square")
{
  CHECK(shader::cookTorrance::gaussianDistribution(1.0f, 0.3f, 2.5f) == 2.5f);
  for (const double degrees : { 10.0, 30.0, 60.0, 80.0 })
  {
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    const auto square = static_cast<float>(std::cos(angle) * std::cos(angle));
    const double expected = 2.5 * std::exp(-angle * angle / 0.25);
    // The angle's roundings, over m^2.
    CHECK(shader::cookTorrance::gaussianDistribution(square, 0.5f, 2.5f) ==
      Approx(expected).epsilon(1e-5));
  }
}
