#include "Catch.h"
#include "ShaderMathematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr float Largest = std::numeric_limits<float>::max();
constexpr float Tiny = std::numeric_limits<float>::denorm_min();
constexpr float Epsilon = std::numeric_limits<float>::epsilon();
}

TEST_CASE("Attenuation is between 0 and 1 for all values and distances")
{
  const float values[] = { -Largest, -1.0f, -Tiny, 0.0f, Tiny, 0.5f, 1.0f, 1e10f, Largest };
  for (const float c1 : values)
  {
    for (const float c2 : values)
    {
      for (const float c3 : values)
      {
        for (const float distance : { 0.0f, Tiny, 1e-3f, 1.0f, 1e3f, Largest })
        {
          const float value = shader::distanceAttenuation(c1, c2, c3, distance);
          CHECK((value >= 0.0f && value <= 1.0f));
        }
      }
    }
  }
}

TEST_CASE("Attenuation is 1 where the denominator is not positive, and where it is below 1")
{
  CHECK(shader::distanceAttenuation(0.0f, 0.0f, 0.0f, 3.0f) == 1.0f);
  CHECK(shader::distanceAttenuation(-5.0f, 1.0f, 0.0f, 3.0f) == 1.0f);
  CHECK(shader::distanceAttenuation(-3.0f, 1.0f, 0.0f, 3.0f) == 1.0f);
  CHECK(shader::distanceAttenuation(0.25f, 0.0f, 0.0f, 3.0f) == 1.0f);
  CHECK(shader::distanceAttenuation(1.0f, 0.0f, 0.0f, 3.0f) == 1.0f);
}

TEST_CASE("Attenuation is the reciprocal of its polynomial in the distance")
{
  CHECK(shader::distanceAttenuation(4.0f, 0.0f, 0.0f, 9.0f) == 0.25f);
  CHECK(shader::distanceAttenuation(0.0f, 0.5f, 0.0f, 8.0f) == 0.25f);
  CHECK(shader::distanceAttenuation(0.0f, 0.0f, 0.25f, 8.0f) == 0.0625f);
  for (const float distance : { 0.5f, 1.0f, 17.0f, 1e4f })
  {
    const double d = distance;
    // Five roundings.
    CHECK(shader::distanceAttenuation(1.0f, 0.5f, 0.25f, distance) ==
      Approx(1.0 / (1.0 + 0.5 * d + 0.25 * d * d)).epsilon(5.0 * Epsilon));
  }
}

TEST_CASE("Attenuation never grows with the distance where no value is negative")
{
  for (const float c2 : { 0.0f, 0.01f, 1.0f })
  {
    for (const float c3 : { 0.0f, 0.01f, 1.0f })
    {
      for (float distance = 1e-6f; distance < 1e6f; distance *= 1.25f)
      {
        CHECK(shader::distanceAttenuation(0.5f, c2, c3, 1.25f * distance) <=
          shader::distanceAttenuation(0.5f, c2, c3, distance));
      }
    }
  }
}

TEST_CASE("A cone's light is between 0 and 1 for every angle and exponent")
{
  for (const float cosine : { -1.0f, -Tiny, 0.0f, Tiny, 0.5f, 1.0f, 1.0f + 4.0f * Epsilon })
  {
    for (const float border : { 0.0f, Tiny, 0.5f, 1.0f })
    {
      for (const float exponent : { 0.0f, Tiny, 1.0f, 128.0f, Largest })
      {
        const float value = shader::coneFalloff(cosine, border, exponent);
        CHECK((value >= 0.0f && value <= 1.0f));
      }
    }
  }
}

TEST_CASE("A cone's light ends at its border, which still belongs to it")
{
  for (const float border : { 0.1f, 0.5f, 0.9f, 1.0f })
  {
    CHECK(shader::coneFalloff(border, border, 0.0f) == 1.0f);
    CHECK(shader::coneFalloff(border, border, 1.0f) == Approx(border).epsilon(Epsilon));
    CHECK(shader::coneFalloff(std::nextafter(border, 0.0f), border, 0.0f) == 0.0f);
    CHECK(shader::coneFalloff(std::nextafter(border, 2.0f), border, 0.0f) == 1.0f);
  }
}

TEST_CASE("No light goes backwards, however wide the cone")
{
  CHECK(shader::coneFalloff(0.0f, 0.0f, 0.0f) == 0.0f);
  CHECK(shader::coneFalloff(-0.5f, -1.0f, 0.0f) == 0.0f);
  CHECK(shader::coneFalloff(-0.5f, -1.0f, 2.0f) == 0.0f);
}

TEST_CASE("Within a cone light is the cosine to the exponent, 1 on the axis")
{
  for (const float exponent : { 0.0f, 0.5f, 1.0f, 20.0f, 128.0f })
  {
    CHECK(shader::coneFalloff(1.0f, 0.5f, exponent) == 1.0f);
    float before = 0.0f;
    for (float cosine = 0.5f; cosine < 1.0f; cosine += 0.01f)
    {
      const float value = shader::coneFalloff(cosine, 0.5f, exponent);
      CHECK(value >= before);
      // One rounding of the result.
      CHECK(value == Approx(std::pow(static_cast<double>(cosine), exponent)).epsilon(Epsilon));
      before = value;
    }
  }
}
