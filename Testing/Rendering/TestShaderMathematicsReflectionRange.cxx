#include "Catch.h"
#include "ShaderMathematics.h"

#include <vtkMath.h>

#include <limits>

TEST_CASE("Phong's terms are finite and between 0 and 1 for every cosine and power")
{
  const float tiny = std::numeric_limits<float>::denorm_min();
  const float above = 1.0f + 4.0f * std::numeric_limits<float>::epsilon();
  const float cosines[] = { -above, -1.0f, -0.5f, -tiny, -0.0f, 0.0f, tiny, 0.5f, 1.0f, above };
  for (const float nDotL : cosines)
  {
    CHECK(shader::diffuseReflection(nDotL) >= 0.0f);
    CHECK(shader::diffuseReflection(nDotL) <= above);
    for (const float nDotV : cosines)
    {
      for (const float lDotV : cosines)
      {
        for (const float power : { 0.0f, tiny, 1.0f, 1e3f, std::numeric_limits<float>::max() })
        {
          const float value = shader::specularReflection(nDotL, nDotV, lDotV, power);
          CHECK((value >= 0.0f && value <= 1.0f));
        }
      }
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
      diffuse += 2.0 * vtkMath::Pi() / rings * shader::diffuseReflection(height);
      specular +=
        2.0 * vtkMath::Pi() / rings * shader::specularReflection(1.0f, height, height, power);
    }
    // 4000 rings leave an error of 1e-5 in the steepest of these lobes.
    CHECK(diffuse == Approx(vtkMath::Pi()).epsilon(1e-4));
    CHECK(specular == Approx(2.0 * vtkMath::Pi() / (power + 1.0)).epsilon(1e-4));
  }
}
