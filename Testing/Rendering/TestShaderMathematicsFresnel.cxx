#include "Catch.h"
#include "ReflectionFormulae.h"
#include "ReflectionTolerance.h"

#include <initializer_list>

namespace
{
constexpr std::initializer_list<float> Indices = { 0.2f, 0.667f, 0.99f, 1.01f, 1.33f, 1.5f, 2.4f,
  10.0f, 1000.0f };

// g is the root of n^2 - 1 + c^2, whose rounding it makes much of near total reflection. F changes
// by at most 4 / (g + c) with g.
double ErrorOf(float cosine, float n)
{
  const double square = std::max(static_cast<double>(n) * n - 1.0 + cosine * cosine, 0.0);
  const double rounding = Epsilon * std::max(1.0, static_cast<double>(n) * n);
  const double error = std::sqrt(square + rounding) - std::sqrt(std::max(square - rounding, 0.0));
  return 4.0 * error / (std::sqrt(square) + cosine) + 8.0 * Epsilon;
}
}

TEST_CASE("Fresnel's reflectance is that of the two polarizations")
{
  for (const float n : Indices)
  {
    for (float cosine = 0.002f; cosine <= 1.0f; cosine += 0.002f)
    {
      CHECK(shader::fresnelReflectance(cosine, n) ==
        Approx(formula::Fresnel(std::acos(static_cast<double>(cosine)), n))
          .epsilon(0.0)
          .margin(ErrorOf(cosine, n)));
    }
  }
}

TEST_CASE("Fresnel's reflectance at normal incidence is ((n - 1) / (n + 1))^2")
{
  for (const float n : Indices)
  {
    const double root = (n - 1.0) / (n + 1.0);
    CHECK(shader::fresnelReflectance(1.0f, n) ==
      Approx(root * root).epsilon(1e-4).margin(ErrorOf(1.0f, n)));
  }
}

TEST_CASE("Everything is reflected at grazing incidence, and in total reflection")
{
  for (const float n : Indices)
  {
    CHECK(shader::fresnelReflectance(0.0f, n) == Approx(1.0).epsilon(4.0 * Epsilon));
  }
  for (const float n : { 0.001f, 0.2f, 0.667f, 0.99f })
  {
    const float critical = std::sqrt(1.0f - n * n);
    for (const float part : { 0.0f, 0.5f, 0.999f })
    {
      CHECK(shader::fresnelReflectance(part * critical, n) == 1.0f);
    }
    CHECK(shader::fresnelReflectance(std::min(1.01f * critical, 1.0f), n) < 1.0f);
  }
}

TEST_CASE("Nothing is reflected where the index of refraction does not change")
{
  for (const float cosine : { 0.0f, 1e-20f, 1e-3f, 0.5f, 1.0f })
  {
    // The squares of 1e-20 and 1e-3 are lost beside 1, or in part.
    const float reflectance = shader::fresnelReflectance(cosine, 1.0f);
    CHECK(reflectance == Approx(0.0).margin(cosine >= 1e-3f || cosine == 0.0f ? 1e-3 : 1.0));
  }
}

TEST_CASE("Fresnel's reflectance of glass falls from grazing to normal incidence")
{
  for (const float n : { 1.1f, 1.33f, 1.5f, 2.4f, 3.5f })
  {
    float before = 1.0f;
    for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.001f)
    {
      const float reflectance = shader::fresnelReflectance(cosine, n);
      // A few roundings.
      CHECK(reflectance <= before + 8.0f * Epsilon);
      before = reflectance;
    }
  }
}

TEST_CASE("Fresnel's reflectance is between 0 and 1 for every cosine and index")
{
  for (const float cosine : { 0.0f, 1e-45f, 1e-20f, 1e-3f, 0.5f, 1.0f, 1.000001f })
  {
    for (const float n : { 0.0f, 0.001f, 0.5f, 0.999999f, 1.0f, 1.000001f, 1.5f, 1e3f, 1e6f })
    {
      const float reflectance = shader::fresnelReflectance(cosine, n);
      CHECK((reflectance >= 0.0f && reflectance <= 1.0f));
    }
  }
}
