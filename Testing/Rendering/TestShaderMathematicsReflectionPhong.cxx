#include "Catch.h"
#include "ReflectionFormulae.h"

#include <vtkMath.h>

#include <cmath>
#include <limits>

namespace
{
constexpr float Powers[] = { 0.0f, 1e-30f, 0.5f, 1.0f, 10.0f, 128.0f };

float Specular(const ReflectionDirections& directions, float power)
{
  return shader::phong::specularReflection(CosinesOf(directions), { power });
}

float Specular(const Vector& light, const Vector& view, float power)
{
  ReflectionDirections directions;
  directions.L = light;
  directions.V = view;
  return Specular(directions, power);
}

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
    const ReflectionDirections directions = RandomDirections(generator);
    for (const float power : { 1.0f, 10.0f, 128.0f })
    {
      CHECK(Specular(directions, power) ==
        Approx(formula::Phong(directions, power)).margin(ErrorOf(power)));
    }
  }
}

TEST_CASE("Phong's highlight is 1 where the eye is in the mirrored direction, for every power")
{
  std::mt19937 generator(21);
  for (int sample = 0; sample < 200; ++sample)
  {
    ReflectionDirections directions = RandomDirections(generator);
    const double height = Dot(directions.N, directions.L);
    directions.V = Sum(2.0 * height, directions.N, -1.0, directions.L);
    if (height > 0.01)
    {
      for (const float power : Powers)
      {
        CHECK(Specular(directions, power) == Approx(1.0).margin(ErrorOf(power)));
      }
    }
  }
}

TEST_CASE("A power of 0 gives 1 wherever there is light, and 0 elsewhere")
{
  CHECK(Specular(AtAngles(30.0), AtAngles(59.0), 0.0f) == 1.0f);
  CHECK(Specular(AtAngles(30.0), AtAngles(61.0), 0.0f) == 0.0f);
  CHECK(Specular(AtAngles(91.0), AtAngles(-80.0), 0.0f) == 0.0f);
}

TEST_CASE("Phong's highlight is not cut where the eye is behind the surface")
{
  const double expected = std::pow(std::cos(vtkMath::RadiansFromDegrees(10.0)), 10.0);
  CHECK(Specular(AtAngles(85.0), AtAngles(-95.0), 10.0f) == Approx(expected).epsilon(1e-5));
}

TEST_CASE("Phong's highlight weakens with the angle from the mirrored direction and with the power")
{
  for (const float power : { 0.5f, 1.0f, 10.0f, 128.0f })
  {
    for (double angle = 1.0; angle < 90.0; angle += 1.0)
    {
      const float nearer = Specular(AtAngles(0.0), AtAngles(angle - 1.0), power);
      const float farther = Specular(AtAngles(0.0), AtAngles(angle), power);
      CHECK(farther <= nearer);
      CHECK(Specular(AtAngles(0.0), AtAngles(angle), power + 1.0f) <= farther);
    }
  }
}

TEST_CASE("Phong's terms integrate to pi and to 2 pi / (n + 1) over the hemisphere")
{
  constexpr int rings = 4000;
  for (const float power : { 0.0f, 0.5f, 1.0f, 10.0f, 128.0f })
  {
    double diffuse = 0.0;
    double specular = 0.0;
    for (int ring = 0; ring < rings; ++ring)
    {
      // Rings of equal height have equal areas on the sphere.
      const float height = (static_cast<float>(ring) + 0.5f) / rings;
      const shader::ReflectionCosines cosines = { height, 1.0f, height, 0.0f, 0.0f, 0.0f };
      const double area = 2.0 * vtkMath::Pi() / rings;
      diffuse += area * shader::phong::diffuseReflection(cosines, { power });
      specular += area * shader::phong::specularReflection(cosines, { power });
    }
    // 4000 rings leave an error of 1e-5 in the steepest of these lobes.
    CHECK(diffuse == Approx(vtkMath::Pi()).epsilon(1e-4));
    CHECK(specular == Approx(2.0 * vtkMath::Pi() / (power + 1.0)).epsilon(1e-4));
  }
}
