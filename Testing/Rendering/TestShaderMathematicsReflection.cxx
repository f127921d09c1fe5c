#include "Catch.h"
#include "ShaderMathematics.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace
{
using Vector = std::array<double, 3>;

constexpr float Powers[] = { 0.0f, 1e-30f, 0.5f, 1.0f, 10.0f, 128.0f };

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector RandomDirection(std::mt19937& generator)
{
  std::normal_distribution<double> normal;
  Vector vector = { normal(generator), normal(generator), normal(generator) };
  vtkMath::Normalize(vector.data());
  return vector;
}

Vector Mirrored(const Vector& light, const Vector& normal)
{
  const double twice = 2.0 * Dot(normal, light);
  return { twice * normal[0] - light[0], twice * normal[1] - light[1],
    twice * normal[2] - light[2] };
}

float Specular(const Vector& normal, const Vector& light, const Vector& view, float power)
{
  return shader::specularReflection(static_cast<float>(Dot(normal, light)),
    static_cast<float>(Dot(normal, view)), static_cast<float>(Dot(light, view)), power);
}

// A direction in the plane of x and z, its angle from z in degrees.
Vector AtAngle(double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  return { std::sin(angle), 0.0, std::cos(angle) };
}
const Vector Normal = { 0.0, 0.0, 1.0 };

// R.V is the difference of products of three rounded cosines: an error of up to four units in the
// last place of 1, which a power raises to its multiple.
double ErrorOf(double power)
{
  return (power + 1.0) * 4.0 * std::numeric_limits<float>::epsilon();
}
}

TEST_CASE("Phong's highlight from cosines is that from vectors")
{
  std::mt19937 generator(20);
  for (int sample = 0; sample < 2000; ++sample)
  {
    const Vector normal = RandomDirection(generator);
    const Vector light = RandomDirection(generator);
    const Vector view = RandomDirection(generator);
    const double mirrored = Dot(Mirrored(light, normal), view);
    const bool lit = Dot(normal, light) > 0.0 && mirrored > 0.0;
    for (const float power : { 1.0f, 10.0f, 128.0f })
    {
      const double expected = lit ? std::pow(mirrored, power) : 0.0;
      CHECK(Specular(normal, light, view, power) == Approx(expected).margin(ErrorOf(power)));
    }
  }
}

TEST_CASE("Phong's highlight is 1 where the eye is in the mirrored direction, for every power")
{
  std::mt19937 generator(21);
  for (int sample = 0; sample < 200; ++sample)
  {
    const Vector normal = RandomDirection(generator);
    const Vector light = RandomDirection(generator);
    if (Dot(normal, light) > 0.01)
    {
      for (const float power : Powers)
      {
        CHECK(Specular(normal, light, Mirrored(light, normal), power) ==
          Approx(1.0).margin(ErrorOf(power)));
      }
    }
  }
}

TEST_CASE("A power of 0 gives 1 wherever there is light, and 0 elsewhere")
{
  CHECK(Specular(Normal, AtAngle(30.0), AtAngle(59.0), 0.0f) == 1.0f);
  CHECK(Specular(Normal, AtAngle(30.0), AtAngle(61.0), 0.0f) == 0.0f);
  CHECK(Specular(Normal, AtAngle(91.0), AtAngle(-80.0), 0.0f) == 0.0f);
}

TEST_CASE("Phong's highlight is not cut where the eye is behind the surface")
{
  const double expected = std::pow(std::cos(vtkMath::RadiansFromDegrees(10.0)), 10.0);
  CHECK(Specular(Normal, AtAngle(85.0), AtAngle(-95.0), 10.0f) == Approx(expected).epsilon(1e-5));
}

TEST_CASE("Phong's highlight weakens with the angle from the mirrored direction and with the power")
{
  for (const float power : { 0.5f, 1.0f, 10.0f, 128.0f })
  {
    for (double angle = 1.0; angle < 90.0; angle += 1.0)
    {
      const float nearer = Specular(Normal, Normal, AtAngle(angle - 1.0), power);
      const float farther = Specular(Normal, Normal, AtAngle(angle), power);
      CHECK(farther <= nearer);
      CHECK(Specular(Normal, Normal, AtAngle(angle), power + 1.0f) <= farther);
    }
  }
}
