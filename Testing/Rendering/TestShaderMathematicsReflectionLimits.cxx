#include "Catch.h"
#include "ModelAlbedo.h"
#include "ReflectionFormulae.h"
#include "ReflectionTolerance.h"

namespace
{
constexpr int Samples = 2000;

// Ward's lobe by the anisotropic model with a preferred direction at that angle to the normal.
ReflectionDirections TurnedTowardsNormal(const ReflectionDirections& d, double degrees)
{
  const double angle = degrees / formula::DegreesPerRadian;
  const Vector tangent = Normalized(Sum(1.0, d.P, -Dot(d.P, d.N), d.N));
  ReflectionDirections turned = d;
  turned.P = Sum(std::cos(angle), d.N, std::sin(angle), tangent);
  return turned;
}
}

TEST_CASE("Oren and Nayar's surface without roughness is Lambert's, to the last bit")
{
  std::mt19937 generator(50);
  const shader::vec4 smooth = OrenNayarParameters(0.0);
  for (int sample = 0; sample < Samples; ++sample)
  {
    const shader::ReflectionCosines cosines = CosinesOf(RandomDirections(generator));
    CHECK(shader::orenNayar::diffuseReflection(cosines, smooth) == std::max(cosines.nDotL, 0.0f));
  }
}

TEST_CASE("Oren and Nayar's surface seen from its light is brighter than Lambert's by tan and sin")
{
  const shader::vec4 rough = OrenNayarParameters(0.5);
  for (double degrees = 0.0; degrees < 90.0; degrees += 1.0)
  {
    ReflectionDirections d;
    d.L = AtAngles(degrees, 20.0);
    d.V = d.L;
    const double sine = std::sin(formula::Angle(d.N, d.L));
    const double cosine = std::cos(formula::Angle(d.N, d.L));
    // A few roundings of numbers up to 1.
    CHECK(shader::orenNayar::diffuseReflection(CosinesOf(d), rough) ==
      Approx(rough.x * cosine + rough.y * sine * sine).margin(4.0 * Epsilon));
  }
}

TEST_CASE("Oren and Nayar's reflection is bounded for eyes right behind the surface")
{
  std::mt19937 generator(51);
  const shader::vec4 rough = OrenNayarParameters(1.0);
  for (int sample = 0; sample < Samples; ++sample)
  {
    for (const double slope : { 0.0, 1e-7, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 1e-2 })
    {
      ReflectionDirections d = RandomDirections(generator);
      d.V = Normalized(Sum(-1.0, d.N, slope, RandomDirection(generator)));
      const double angle = formula::Angle(d.N, d.L);
      // The eye's azimuth is lost to rounding; the bound is that of any.
      const double bound = rough.x * std::max(std::cos(angle), 0.0) + rough.y * std::sin(angle);
      CHECK(shader::orenNayar::diffuseReflection(CosinesOf(d), rough) <= 1.02 * bound);
    }
  }
}

TEST_CASE("Ward's anisotropic lobe of equal roughnesses is the isotropic one for every direction")
{
  std::mt19937 generator(52);
  for (const double roughness : { 0.05, 0.3, 1.0 })
  {
    const auto parameter = static_cast<float>(roughness);
    for (int sample = 0; sample < Samples; ++sample)
    {
      const ReflectionDirections d = RandomHighlight(generator, roughness);
      const shader::ReflectionCosines cosines = CosinesOf(d);
      const double expected = shader::ward::specularReflection(cosines, { parameter });
      CHECK(shader::wardAnisotropic::specularReflection(cosines, { parameter, parameter }) ==
        Approx(expected).epsilon(0.0).margin(ErrorOfLobe(d, expected, roughness * roughness)));
    }
  }
}

TEST_CASE(
  "Ward's exponent goes over to the isotropic one as the preferred direction nears the normal")
{
  std::mt19937 generator(53);
  constexpr double x = 0.2;
  constexpr double y = 0.8;
  const double oneDegree = std::sin(1.0 / formula::DegreesPerRadian);
  for (int sample = 0; sample < Samples; ++sample)
  {
    const ReflectionDirections picked = RandomHighlight(generator, 0.3);
    for (const double degrees : { 0.3, 0.5, 0.9, 0.999, 1.001, 1.2, 3.0 })
    {
      const ReflectionDirections d = TurnedTowardsNormal(picked, degrees);
      const double sine = std::sin(degrees / formula::DegreesPerRadian);
      const double certain = std::min(sine * sine / (oneDegree * oneDegree), 1.0);
      // Both have one peak: of the exponents the mean is of the values the product of powers.
      const double expected = std::pow(formula::Ward(d, std::sqrt(x * y)), 1.0 - certain) *
        std::pow(formula::WardAnisotropic(d, x, y), certain);
      // The square of the sine is 1 - (P.N)^2, rounded, and that times certain remains.
      const double variance = x * x * oneDegree * oneDegree / 4.0;
      CHECK(shader::wardAnisotropic::specularReflection(
              CosinesOf(d), { static_cast<float>(x), static_cast<float>(y) }) ==
        Approx(expected).epsilon(0.0).margin(ErrorOfLobe(d, expected, variance)));
    }
  }
}

TEST_CASE("Ward's lobe of a preferred direction along the normal is that of the mean roughness")
{
  std::mt19937 generator(54);
  for (int sample = 0; sample < Samples; ++sample)
  {
    ReflectionDirections d = RandomHighlight(generator, 0.3);
    d.P = sample % 2 == 0 ? d.N : Sum(-1.0, d.N, 0.0, d.N);
    const double expected = formula::Ward(d, 0.4);
    CHECK(shader::wardAnisotropic::specularReflection(CosinesOf(d), { 0.2f, 0.8f }) ==
      Approx(expected).epsilon(0.0).margin(ErrorOfLobe(d, expected, 0.2 * 0.2)));
  }
}

TEST_CASE("Blinn and Phong's power of 0 gives 1 wherever light and eye are above the horizon")
{
  const shader::vec4 none = {};
  for (const float cosine : { 1e-45f, 1e-20f, 0.01f, 1.0f })
  {
    CHECK(shader::blinnPhong::specularReflection({ cosine, 0.5f, -0.5f, 0, 0, 0 }, none) == 1.0f);
    CHECK(shader::blinnPhong::specularReflection({ 0.5f, cosine, -0.5f, 0, 0, 0 }, none) == 1.0f);
    CHECK(shader::blinnPhong::specularReflection({ -cosine, 0.5f, 0.5f, 0, 0, 0 }, none) == 0.0f);
    CHECK(shader::blinnPhong::specularReflection({ 0.5f, -cosine, 0.5f, 0, 0, 0 }, none) == 0.0f);
  }
}
