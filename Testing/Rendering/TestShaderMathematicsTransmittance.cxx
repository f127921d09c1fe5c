#include "Catch.h"
#include "ShaderMathematics.h"
#include "TransferFunctionTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float Largest = std::numeric_limits<float>::max();
// The greatest opacity that matter has.
constexpr float LargestOpacity = 1.0f - 1.0f / 16777216.0f;
const double LargestExtinction = 24.0 * std::log(2.0);
}

TEST_CASE("Opacity of an optical depth is 1 - exp(-depth), to the last digits of thin matter")
{
  for (double depth = 1e-12; depth < 100.0; depth *= 1.01)
  {
    const auto single = static_cast<float>(depth);
    // The series' error, up to its end at 1/16, and three roundings; beyond it the subtraction's of
    // half a unit in the last place of 1, relative to 0.06.
    const double tolerance = single < 0.0625f ? 4e-7 : 1.5e-6;
    CHECK(shader::opacityOfDepth(single) ==
      Approx(-std::expm1(-static_cast<double>(single))).epsilon(tolerance));
  }
}

TEST_CASE("Opacity of an optical depth goes from 0 to 1 and never falls")
{
  CHECK(shader::opacityOfDepth(0.0f) == 0.0f);
  CHECK(shader::opacityOfDepth(Largest) == 1.0f);
  CHECK(shader::opacityOfDepth(Infinity) == 1.0f);
  float before = 0.0f;
  for (float depth = 1e-12f; depth < 100.0f; depth *= 1.001f)
  {
    const float opacity = shader::opacityOfDepth(depth);
    CHECK((opacity >= before && opacity <= 1.0f));
    before = opacity;
  }
}

TEST_CASE("Two layers of matter are as opaque as one of their whole depth")
{
  for (const float first : { 1e-6f, 0.01f, 0.06f, 0.5f, 3.0f })
  {
    for (const float second : { 1e-6f, 0.02f, 0.07f, 2.0f })
    {
      const float behind = (1.0f - shader::opacityOfDepth(first)) * shader::opacityOfDepth(second);
      CHECK(shader::opacityOfDepth(first) + behind ==
        Approx(shader::opacityOfDepth(first + second)).epsilon(2e-6));
    }
  }
}

TEST_CASE("Extinction of an opacity is -log(1 - opacity)")
{
  for (double opacity = 1e-12; opacity < LargestOpacity; opacity *= 1.01)
  {
    const auto single = static_cast<float>(opacity);
    // Three roundings, up to the end of the series at 1/1024; beyond it 1 - opacity is rounded by
    // half a unit in the last place of 1, relative to 0.001.
    const double tolerance = single < 0.0009765625f ? 2e-7 : 3.2e-5;
    CHECK(shader::extinctionOfOpacity(single) ==
      Approx(-std::log1p(-static_cast<double>(single))).epsilon(tolerance));
  }
  for (double transparency = 1e-6; transparency < 0.5; transparency *= 1.1)
  {
    const auto single = static_cast<float>(1.0 - transparency);
    CHECK(shader::extinctionOfOpacity(single) ==
      Approx(-std::log1p(-static_cast<double>(single))).epsilon(1e-6));
  }
}

TEST_CASE("Extinction is bounded by that of the greatest opacity")
{
  for (const float opacity : { LargestOpacity, 1.0f, 2.0f, Largest, Infinity })
  {
    CHECK(shader::extinctionOfOpacity(opacity) == Approx(LargestExtinction).epsilon(1e-6));
  }
  CHECK(shader::extinctionOfOpacity(0.0f) == 0.0f);
}

TEST_CASE("Matter of an opacity below 0 is none")
{
  for (const float opacity : { -1e-6f, -0.5f, -Largest })
  {
    CHECK(shader::extinctionOfOpacity(opacity) == 0.0f);
    CHECK(penumbra::ComputeExtinction(opacity, 1.0) == 0.0);
  }
}

TEST_CASE("Extinction never falls with the opacity")
{
  float before = 0.0f;
  for (float opacity = 1e-12f; opacity < 1.0f; opacity *= 1.001f)
  {
    const float extinction = shader::extinctionOfOpacity(opacity);
    CHECK(extinction >= before);
    before = extinction;
  }
}

TEST_CASE("The opacity of one unit distance of matter is the opacity it was given")
{
  for (double opacity = 1e-9; opacity < 0.9999; opacity *= 1.03)
  {
    const float extinction = shader::extinctionOfOpacity(static_cast<float>(opacity));
    CHECK(shader::opacityOfDepth(extinction) == Approx(opacity).epsilon(3.3e-5));
  }
}

TEST_CASE("Tables hold the extinction that the shader computes, per length")
{
  for (const double opacity : { 0.0, 1e-9, 1e-3, 0.1, 0.5, 0.999, 1.0, 2.0 })
  {
    const double expected = shader::extinctionOfOpacity(static_cast<float>(opacity));
    CHECK(penumbra::ComputeExtinction(opacity, 1.0) == Approx(expected).epsilon(3.2e-5));
    CHECK(penumbra::ComputeExtinction(opacity, 4.0) == Approx(expected / 4.0).epsilon(3.2e-5));
  }
}
