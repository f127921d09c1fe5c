#include "Catch.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"

using namespace penumbra;

TEST_CASE("Every light is counted by its kind and its shadow state, and nowhere else")
{
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    for (int shadow = 0; shadow < NumberOfShadowKinds; ++shadow)
    {
      const auto light = MakeLight(static_cast<LightKind>(kind), static_cast<ShadowKind>(shadow));
      const auto other = MakeLight(static_cast<LightKind>(kind), static_cast<ShadowKind>(shadow));
      const LightingRequirements requirements = LightsAndMaterial({ light, other }).Requirements();
      decltype(requirements.Lights) expected{};
      expected[kind][shadow] = 2;
      CHECK(requirements.Lights == expected);
      CHECK(requirements.GetNumberOfLights() == 2);
      CHECK(requirements.GetNumberOfLights(static_cast<LightKind>(kind)) == 2);
      CHECK(requirements.GetNumberOfLights(static_cast<ShadowKind>(shadow)) == 2);
      CHECK(requirements.GetNumberOfShadowedLights() == (shadow == 0 ? 0 : 2));
    }
  }
}

TEST_CASE("A cone of 90 degrees or more is a point light's")
{
  const auto light = MakeLight(LightKind::Spot, ShadowKind::None);
  for (const double angle : { 0.0, 45.0, 89.999 })
  {
    light->SetConeAngle(angle);
    CHECK(GetLightKind(light) == LightKind::Spot);
  }
  for (const double angle : { 90.0, 90.001, 180.0 })
  {
    light->SetConeAngle(angle);
    CHECK(GetLightKind(light) == LightKind::Point);
  }
  light->PositionalOff();
  light->SetConeAngle(30.0);
  CHECK(GetLightKind(light) == LightKind::Directional);
}

TEST_CASE("Attenuation is needed where the distance to a light that matters changes its strength")
{
  const auto light = MakeLight(LightKind::Point, ShadowKind::None);
  LightsAndMaterial with({ light });
  CHECK_FALSE(with.Requirements().Attenuation);
  const double values[][3] = { { 2.0, 0.0, 0.0 }, { 1.0, 0.1, 0.0 }, { 1.0, 0.0, 0.1 } };
  for (const auto& value : values)
  {
    light->SetAttenuationValues(value);
    CHECK(with.Requirements().Attenuation);
    CHECK(with.Requirements().GetNumberOfLights(LightKind::Point) == 1);
  }
  light->SetConeAngle(20.0);
  CHECK(with.Requirements().Attenuation);
  light->PositionalOff();
  CHECK_FALSE(with.Requirements().Attenuation);
}

TEST_CASE("A plain light has no shadow")
{
  vtkNew<vtkLight> light;
  CHECK(GetShadowKind(light) == ShadowKind::None);
  CHECK(GetShadowKind(MakeLight(LightKind::Point, ShadowKind::Hard)) == ShadowKind::Hard);
  CHECK(LightsAndMaterial({ light.Get() }).Requirements().GetNumberOfShadowedLights() == 0);
}
