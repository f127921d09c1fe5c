#include "Catch.h"
#include "ModelAlbedo.h"
#include "ReflectionTolerance.h"

#include <functional>

namespace
{
using Model = float (*)(shader::ReflectionCosines, shader::vec4);

// Calls it with directions of light and eye that are both above the horizon, and those exchanged.
void ForBothWays(const std::function<void(shader::ReflectionCosines, shader::ReflectionCosines)>& f)
{
  std::mt19937 generator(40);
  for (int sample = 0; sample < 4000; ++sample)
  {
    const ReflectionDirections directions = RandomHighlight(generator, 0.4);
    const shader::ReflectionCosines there = CosinesOf(directions);
    // Nearer to the horizon the models bound 1 / N.V, which has no end.
    if (there.nDotL > 1e-4f && there.nDotV > 1e-4f)
    {
      f(there, CosinesOf(Reversed(directions)));
    }
  }
}

// F / N.L is the same both ways.
void CheckDistribution(Model model, const shader::vec4& parameters)
{
  ForBothWays(
    [&](const shader::ReflectionCosines& there, const shader::ReflectionCosines& back)
    {
      const double expected = model(back, parameters) / back.nDotL;
      // A few roundings: the exponents are of the same numbers. Below the smallest normal float
      // there are fewer digits.
      CHECK(model(there, parameters) / there.nDotL ==
        Approx(expected).epsilon(8.0 * Epsilon).margin(1e-32));
    });
}

// F itself is.
void CheckFactor(Model model, const shader::vec4& parameters)
{
  ForBothWays([&](const shader::ReflectionCosines& there, const shader::ReflectionCosines& back)
    { CHECK(model(there, parameters) == model(back, parameters)); });
}
}

TEST_CASE("Oren and Nayar's reflectance distribution is the same from light to eye and back")
{
  for (const double roughness : { 0.0, 0.1, 0.3, 1.0 })
  {
    CheckDistribution(shader::orenNayar::diffuseReflection, OrenNayarParameters(roughness));
  }
}

TEST_CASE("Ward's reflectance distribution is the same from light to eye and back")
{
  for (const float roughness : { 0.1f, 0.3f, 1.0f })
  {
    CheckDistribution(shader::ward::specularReflection, { roughness });
  }
}

TEST_CASE("Ward's anisotropic reflectance distribution is the same from light to eye and back")
{
  CheckDistribution(shader::wardAnisotropic::specularReflection, { 0.1f, 0.5f });
  CheckDistribution(shader::wardAnisotropic::specularReflection, { 1.0f, 0.2f });
}

TEST_CASE("Cook and Torrance's reflectance distribution is the same from light to eye and back")
{
  for (const float slope : { 0.1f, 0.3f, 1.0f })
  {
    CheckDistribution(shader::cookTorrance::specularReflection, { slope, -1.0f });
    CheckDistribution(shader::cookTorrance::specularReflection, { slope, 1.0f });
  }
}

TEST_CASE("Phong's factor, and Blinn and Phong's, are the same from light to eye and back")
{
  for (const float power : { 0.0f, 1.0f, 10.0f, 128.0f })
  {
    CheckFactor(shader::phong::specularReflection, { power });
    CheckFactor(shader::blinnPhong::specularReflection, { power });
  }
}

TEST_CASE("As reflectance distributions Phong's and Blinn and Phong's factors are not reciprocal")
{
  ReflectionDirections directions;
  directions.L = AtAngles(60.0);
  directions.V = AtAngles(-45.0);
  const shader::ReflectionCosines there = CosinesOf(directions);
  const shader::ReflectionCosines back = CosinesOf(Reversed(directions));
  for (const auto model :
    { shader::phong::specularReflection, shader::blinnPhong::specularReflection })
  {
    const double ratio =
      model(there, { 10.0f }) / there.nDotL / (model(back, { 10.0f }) / back.nDotL);
    // cos 45 / cos 60 degrees.
    CHECK(ratio == Approx(std::sqrt(2.0)).epsilon(1e-5));
  }
}
