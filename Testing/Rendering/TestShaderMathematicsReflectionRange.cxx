#include "Catch.h"
#include "ReflectionGeometry.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

namespace
{
using Model = float (*)(shader::ReflectionCosines, shader::vec4);

constexpr float Tiny = std::numeric_limits<float>::denorm_min();
constexpr float Above = 1.0f + 4.0f * std::numeric_limits<float>::epsilon();

// All that the mapper passes.
const std::vector<shader::vec4> Powers = { { 0.0f }, { Tiny }, { 1e-30f }, { 0.5f }, { 1.0f },
  { 128.0f }, { 1e6f }, { std::numeric_limits<float>::max() } };
const std::vector<shader::vec4> Facets = { { 1.0f, 0.0f }, { 0.9f, 0.3f }, { 0.5f, 0.45f } };
const std::vector<shader::vec4> Lobes = { { 0.001f, 0.001f }, { 0.001f, 1e6f }, { 0.1f, 0.5f },
  { 1.0f, 1.0f }, { 1e6f, 0.001f }, { 1e6f, 1e6f } };
const std::vector<shader::vec4> Slopes = { { 0.001f, -1.0f }, { 0.3f, -1.0f }, { 1e6f, -1.0f },
  { 0.001f, 0.0f }, { 0.001f, 1e6f }, { 0.3f, 1.0f }, { 1e6f, 1e6f } };

struct NamedModel
{
  const char* Name;
  Model Reflection;
  std::vector<shader::vec4> Parameters;
  float Most;
  bool HiddenBehind; // where N.V <= 0
};

const std::vector<NamedModel>& Models()
{
  constexpr float none = std::numeric_limits<float>::max();
  static const std::vector<NamedModel> models = {
    { "Lambert", shader::phong::diffuseReflection, Powers, Above, false },
    { "Phong", shader::phong::specularReflection, Powers, 1.0f, false },
    { "Blinn-Phong", shader::blinnPhong::specularReflection, Powers, 1.0f, true },
    { "Oren-Nayar", shader::orenNayar::diffuseReflection, Facets, none, false },
    { "Ward", shader::ward::specularReflection, Lobes, none, true },
    { "Ward, anisotropic", shader::wardAnisotropic::specularReflection, Lobes, none, true },
    { "Cook-Torrance", shader::cookTorrance::specularReflection, Slopes, none, true },
  };
  return models;
}

void CheckRange(const shader::ReflectionCosines& c)
{
  for (const NamedModel& model : Models())
  {
    for (const shader::vec4& parameters : model.Parameters)
    {
      const float value = model.Reflection(c, parameters);
      if (!std::isfinite(value) || value < 0.0f || value > model.Most)
      {
        FAIL_CHECK(model.Name << " of " << parameters.x << ", " << parameters.y << " is " << value
                              << " at N.L " << c.nDotL << ", N.V " << c.nDotV << ", L.V " << c.lDotV
                              << ", P.N " << c.pDotN << ", P.L " << c.pDotL << ", P.V " << c.pDotV);
      }
      if (c.nDotL <= 0.0f && value != 0.0f)
      {
        FAIL_CHECK(model.Name << " is lit from behind");
      }
    }
  }
}
}

TEST_CASE("Reflections are finite and not negative for all cosines, also those of no directions")
{
  const std::vector<float> cosines = { -Above, -1.0f, -0.5f, -1e-3f, -1e-20f, -Tiny, -0.0f, 0.0f,
    Tiny, 1e-20f, 1e-7f, 1e-3f, 0.5f, 1.0f, Above };
  std::mt19937 generator(60);
  std::uniform_int_distribution<size_t> any(0, cosines.size() - 1);
  const auto pick = [&] { return cosines[any(generator)]; };
  for (const float nDotL : cosines)
  {
    for (const float nDotV : cosines)
    {
      for (const float lDotV : cosines)
      {
        CheckRange({ nDotL, nDotV, lDotV, pick(), pick(), pick() });
        CheckRange({ nDotL, nDotV, lDotV, pick(), pick(), pick() });
      }
    }
  }
}

TEST_CASE("Reflections are finite and not negative for all directions")
{
  std::mt19937 generator(61);
  for (int sample = 0; sample < 10000; ++sample)
  {
    CheckRange(CosinesOf(RandomDirections(generator)));
    CheckRange(CosinesOf(RandomHighlight(generator, 0.01)));
  }
}

TEST_CASE("Reflections are finite and not negative where directions are the same or opposite")
{
  std::mt19937 generator(62);
  for (int sample = 0; sample < 1000; ++sample)
  {
    for (const double apart : { 0.0, 1e-8, 1e-4 })
    {
      ReflectionDirections d = RandomDirections(generator);
      const auto near = [&](double sign, const Vector& direction)
      { return Normalized(Sum(sign, direction, apart, RandomDirection(generator))); };
      d.V = near(-1.0, d.L);
      CheckRange(CosinesOf(d));
      d.N = near(1.0, Normalized(Cross(d.L, d.P))); // and both along the surface
      CheckRange(CosinesOf(d));
      d.N = near(1.0, d.L);
      d.V = near(1.0, d.L);
      d.P = near(1.0, d.L);
      CheckRange(CosinesOf(d));
    }
  }
}

TEST_CASE("No light along the surface is reflected, and no highlight behind it but Phong's")
{
  for (const float nDotV : { 0.0f, -Tiny, -0.5f, -1.0f })
  {
    for (const NamedModel& model : Models())
    {
      for (const shader::vec4& parameters : model.Parameters)
      {
        CHECK(model.Reflection({ 0.0f, 0.5f, 0.5f, 0.0f, 0.5f, 0.5f }, parameters) == 0.0f);
        if (model.HiddenBehind)
        {
          CHECK(model.Reflection({ 0.5f, nDotV, 0.5f, 0.0f, 0.5f, 0.5f }, parameters) == 0.0f);
        }
      }
    }
  }
}
