#include "Catch.h"
#include "ModelAlbedo.h"
#include "ReflectionFormulae.h"
#include "ReflectionTolerance.h"

namespace
{
constexpr int Samples = 4000;

// Directions of all kinds, every other pair in the highlight of a surface of that roughness.
ReflectionDirections Pick(int sample, std::mt19937& generator, double roughness)
{
  return sample % 2 == 0 ? RandomDirections(generator)
                         : RandomHighlight(generator, std::min(roughness, 1.0));
}

// Of two numbers that must agree: that they do, and whether it says something.
bool Compare(double value, double expected, double tolerance)
{
  CHECK(value == Approx(expected).epsilon(0.0).margin(tolerance));
  return expected > 0.0 && tolerance < 0.01 * expected;
}
}

TEST_CASE("Oren and Nayar's reflection from cosines is that from angles")
{
  std::mt19937 generator(30);
  for (int sample = 0; sample < Samples; ++sample)
  {
    const ReflectionDirections d = RandomDirections(generator);
    for (const double roughness : { 0.0, 0.1, 0.3, 1.0, 3.0 })
    {
      const shader::vec4 parameters = OrenNayarParameters(roughness);
      // A handful of roundings of numbers up to 1. Behind the surface the distance from its normal
      // divides them.
      const double tolerance = 8.0 * Epsilon / std::sin(formula::Angle(d.N, d.V));
      CHECK(shader::orenNayar::diffuseReflection(CosinesOf(d), parameters) ==
        Approx(formula::OrenNayar(d, roughness)).margin(tolerance));
      CHECK(shader::orenNayar::specularReflection(CosinesOf(d), parameters) == 0.0f);
    }
  }
}

TEST_CASE("Blinn and Phong's highlight from cosines is that from the half vector")
{
  std::mt19937 generator(31);
  for (const float power : { 0.0f, 0.5f, 1.0f, 10.0f, 128.0f })
  {
    int telling = 0;
    for (int sample = 0; sample < Samples; ++sample)
    {
      const ReflectionDirections d = Pick(sample, generator, 0.5);
      const double expected = formula::BlinnPhong(d, power);
      const double tolerance = expected * std::expm1((power + 1.0) * ErrorOfHalf(d));
      telling += Compare(shader::blinnPhong::specularReflection(CosinesOf(d), { power }), expected,
        tolerance + std::numeric_limits<float>::min());
    }
    CHECK(telling > Samples / 3);
  }
}

TEST_CASE("Ward's lobe from cosines is that from angles")
{
  std::mt19937 generator(32);
  for (const double roughness : { 0.03, 0.1, 0.3, 1.0, 10.0 })
  {
    int telling = 0;
    const auto parameter = static_cast<float>(roughness);
    for (int sample = 0; sample < Samples; ++sample)
    {
      const ReflectionDirections d = Pick(sample, generator, roughness);
      const double expected = formula::Ward(d, parameter);
      telling += Compare(shader::ward::specularReflection(CosinesOf(d), { parameter }), expected,
        ErrorOfLobe(d, expected, roughness * roughness));
    }
    CHECK(telling > Samples / 4);
  }
}

TEST_CASE("Ward's anisotropic lobe from cosines is that from angles")
{
  std::mt19937 generator(33);
  const float roughnesses[][2] = { { 0.1f, 0.5f }, { 0.5f, 0.1f }, { 0.05f, 0.05f },
    { 1.0f, 3.0f } };
  for (const auto& roughness : roughnesses)
  {
    const double least = std::min(roughness[0], roughness[1]);
    int telling = 0;
    for (int sample = 0; sample < Samples; ++sample)
    {
      ReflectionDirections d = Pick(sample, generator, least);
      // Its projection's direction is less certain than P by the projection's length.
      const double projection = std::sin(formula::Angle(d.P, d.N));
      if (projection > 0.1)
      {
        const double expected = formula::WardAnisotropic(d, roughness[0], roughness[1]);
        const double variance = least * least * projection * projection / 4.0;
        telling += Compare(
          shader::wardAnisotropic::specularReflection(CosinesOf(d), { roughness[0], roughness[1] }),
          expected, ErrorOfLobe(d, expected, variance));
      }
    }
    CHECK(telling > Samples / 4);
  }
}

TEST_CASE("Cook and Torrance's reflection from cosines is that from angles")
{
  std::mt19937 generator(34);
  for (const double slope : { 0.03, 0.1, 0.3, 1.0, 10.0 })
  {
    const auto m = static_cast<float>(slope);
    int telling = 0;
    for (int sample = 0; sample < Samples; ++sample)
    {
      const ReflectionDirections d = Pick(sample, generator, slope);
      const shader::ReflectionCosines cosines = CosinesOf(d);
      const double beckmann = formula::CookTorranceBeckmann(d, m);
      telling += Compare(shader::cookTorrance::specularReflection(cosines, { m, -1.0f }), beckmann,
        ErrorOfLobe(d, beckmann, slope * slope));
      const double gaussian = formula::CookTorranceGaussian(d, m, 2.5);
      telling += Compare(shader::cookTorrance::specularReflection(cosines, { m, 2.5f }), gaussian,
        ErrorOfLobe(d, gaussian, slope * slope));
    }
    CHECK(telling > Samples / 2);
  }
}

TEST_CASE("What is lit besides the models' highlights is Lambert's")
{
  std::mt19937 generator(35);
  const auto models = { shader::phong::diffuseReflection, shader::blinnPhong::diffuseReflection,
    shader::ward::diffuseReflection, shader::wardAnisotropic::diffuseReflection,
    shader::cookTorrance::diffuseReflection };
  for (int sample = 0; sample < Samples; ++sample)
  {
    const ReflectionDirections d = RandomDirections(generator);
    for (const auto model : models)
    {
      // One rounding.
      CHECK(model(CosinesOf(d), { 0.3f, 0.5f }) == Approx(formula::Lambert(d)).margin(Epsilon));
    }
  }
}
