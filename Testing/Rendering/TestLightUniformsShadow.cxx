#include "Catch.h"
#include "LightUniforms.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"
#include "PlacedVolume.h"

#include <cmath>

using namespace penumbra;

namespace
{
LightUniforms::Vector2f GetShadow(vtkLight* light, const VolumePlacement& geometry)
{
  const LightsAndMaterial scene({ light });
  return MakeLightUniforms(scene.lights, scene.property, geometry, { 0.0, 0.0, -1.0 }).Shadow.at(0);
}
}

TEST_CASE("A shadow ray begins the bias away, by default the smallest spacing")
{
  const auto light = MakeLight(LightKind::Point, ShadowKind::Soft);
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    light->SetShadowBias(-1.0);
    const auto smallest = static_cast<float>(volume.image->GetSpacing()[0]);
    CHECK(GetShadow(light, geometry)[0] == smallest);
    light->SetShadowBias(0.0);
    CHECK(GetShadow(light, geometry)[0] == 0.0f);
    light->SetShadowBias(2.5);
    CHECK(GetShadow(light, geometry)[0] == 2.5f);
  }
}

TEST_CASE("A threshold is passed as the optical depth beyond which a hard shadow is complete")
{
  const VolumePlacement geometry = MakePlacedVolumes().front().Geometry();
  const auto light = MakeLight(LightKind::Directional, ShadowKind::Hard);
  CHECK(GetShadow(light, geometry)[1] == Approx(-std::log(0.05)));
  light->SetOpacityThreshold(0.0);
  CHECK(GetShadow(light, geometry)[1] == 0.0f);
  // At most that of the greatest opacity.
  light->SetOpacityThreshold(1.0);
  CHECK(GetShadow(light, geometry)[1] == Approx(24.0 * std::log(2.0)));
}

TEST_CASE("A light without a direction gives finite uniforms")
{
  const VolumePlacement geometry = MakePlacedVolumes().front().Geometry();
  const auto light = MakeLight(LightKind::Directional, ShadowKind::Soft);
  light->SetFocalPoint(light->GetPosition());
  const LightsAndMaterial scene({ light });
  const LightUniforms uniforms =
    MakeLightUniforms(scene.lights, scene.property, geometry, { 0.0, 0.0, -1.0 });
  CHECK(uniforms.Position.at(0) == LightUniforms::Vector3f{});
  const LightUniforms::Vector3f& direction = uniforms.Direction.at(0);
  CHECK(std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]) == 0.0f);
}
