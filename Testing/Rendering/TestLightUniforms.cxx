#include "Catch.h"
#include "LightUniforms.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"
#include "PlacedVolume.h"

#include <vtkTransform.h>

#include <cmath>

using namespace penumbra;

namespace
{
using Vector3f = LightUniforms::Vector3f;

const Vector3 CameraDirection = { 0.0, 0.6, -0.8 };
// Of values that are rounded to floats.
constexpr double Rounding = 1e-6;

Vector3 ToDouble(const Vector3f& vector)
{
  return { vector[0], vector[1], vector[2] };
}

LightUniforms MakeUniforms(const LightsAndMaterial& scene, const VolumePlacement& geometry)
{
  LightUniforms uniforms =
    MakeLightUniforms(scene.lights, scene.property, geometry, CameraDirection);
  uniforms.SetAmbient(ComputeAmbientLight(scene.lights), scene.property->GetAmbient(0));
  return uniforms;
}

LightUniforms MakeUniforms(const LightsAndMaterial& scene)
{
  return MakeUniforms(scene, MakePlacedVolumes().front().Geometry());
}

// From the light of MakeLight towards its focal point.
const Vector3 Travel = Normalized({ -25.0, -35.0, -45.0 });
}

TEST_CASE("Lights are sorted by kind and shadow state, and those that do not matter are missing")
{
  LightsAndMaterial scene;
  std::vector<double> expected(9);
  for (const int mixed : { 4, 8, 0, 6, 2, 7, 1, 5, 3 })
  {
    const auto light =
      MakeLight(static_cast<LightKind>(mixed / 3), static_cast<ShadowKind>(mixed % 3));
    light->SetExponent(mixed);
    scene.lights->AddItem(light);
    const auto off = MakeLight(LightKind::Point, ShadowKind::Soft);
    off->SwitchOff();
    scene.lights->AddItem(off);
    expected[mixed] = mixed;
  }
  std::vector<double> found;
  for (const LightUniforms::Vector2f& cone : MakeUniforms(scene).Cone)
  {
    found.push_back(cone[1]);
  }
  CHECK(found == expected);
}

TEST_CASE("A directional light comes from where its focal point sees it, at every sample")
{
  const auto light = MakeLight(LightKind::Directional, ShadowKind::Soft);
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    const VolumePlacement geometry = volume.Geometry();
    const LightUniforms uniforms = MakeUniforms(LightsAndMaterial({ light }), geometry);
    const Vector3 towards = { -Travel[0], -Travel[1], -Travel[2] };
    CHECK(GetDistance(ToDouble(uniforms.Direction.at(0)), towards) <= Rounding);
    // The shadow ray has the same direction, and the length 1 in the own frame.
    const Vector3 ray = ToDouble(uniforms.Position.at(0));
    CHECK(GetLength(MultiplyDirection(geometry.TextureToOwn, ray)) == Approx(1.0));
    const Vector3 inWorld = Normalized(MultiplyDirection(geometry.TextureToWorld, ray));
    CHECK(GetDistance(inWorld, towards) <= Rounding);
  }
}

TEST_CASE("A headlight shines along the direction of projection")
{
  const auto light = MakeLight(LightKind::Directional, ShadowKind::None);
  light->SetLightTypeToHeadlight();
  const LightUniforms uniforms = MakeUniforms(LightsAndMaterial({ light }));
  CHECK(uniforms.Direction.at(0) == Vector3f{ -0.0f, -0.6f, 0.8f });
}

TEST_CASE("Point and spot lights are at their position in texture coordinates")
{
  const auto light = MakeLight(LightKind::Spot, ShadowKind::Hard);
  light->SetConeAngle(60.0);
  for (const PlacedVolume& volume : MakePlacedVolumes())
  {
    INFO(volume.name);
    // A place near the volume, where texture coordinates are of order 1.
    const Vector3 texture = { 1.5, -0.25, 0.75 };
    const Vector3 world = volume.ToWorld(texture);
    light->SetPosition(world[0], world[1], world[2]);
    light->SetFocalPoint(world[0] - 25.0, world[1] - 35.0, world[2] - 45.0);
    const LightUniforms uniforms = MakeUniforms(LightsAndMaterial({ light }), volume.Geometry());
    CHECK(GetDistance(ToDouble(uniforms.Position.at(0)), texture) <= Rounding);
    CHECK(GetDistance(ToDouble(uniforms.Direction.at(0)), Travel) <= Rounding);
    CHECK(uniforms.Cone.at(0)[0] == Approx(0.5));
  }
}

TEST_CASE("A light's transform moves its place and its direction")
{
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, 2.0, 3.0);
  transform->RotateZ(90.0);
  const auto light = MakeLight(LightKind::Directional, ShadowKind::None);
  light->SetLightTypeToCameraLight();
  light->SetTransformMatrix(transform->GetMatrix());
  const LightUniforms uniforms = MakeUniforms(LightsAndMaterial({ light }));
  const Vector3 expected = { Travel[1], -Travel[0], -Travel[2] };
  CHECK(GetDistance(ToDouble(uniforms.Direction.at(0)), expected) <= Rounding);
}

TEST_CASE("Colours are multiplied by intensity and by the material's factors")
{
  const auto light = MakeLight(LightKind::Point, ShadowKind::None);
  light->SetAmbientColor(0.5, 0.25, 1.0);
  light->SetDiffuseColor(1.0, 0.5, 0.0);
  light->SetSpecularColor(0.0, 1.0, 0.5);
  light->SetIntensity(2.0);
  light->SetAttenuationValues(1.0, 2.0, 3.0);
  LightsAndMaterial scene({ light });
  scene.property->SetAmbient(0.125);
  scene.property->SetDiffuse(0.5);
  scene.property->SetSpecular(0.25);
  const LightUniforms uniforms = MakeUniforms(scene);
  CHECK(uniforms.Ambient == Vector3f{ 0.125f, 0.0625f, 0.25f });
  CHECK(uniforms.Diffuse.at(0) == Vector3f{ 1.0f, 0.5f, 0.0f });
  CHECK(uniforms.Specular.at(0) == Vector3f{ 0.0f, 0.5f, 0.25f });
  CHECK(uniforms.Attenuation.at(0) == Vector3f{ 1.0f, 2.0f, 3.0f });
}

TEST_CASE("Shadows are as bright as what their lights add, by the root of the sum of squares")
{
  const auto shadowed = MakeLight(LightKind::Directional, ShadowKind::Soft);
  const auto other = MakeLight(LightKind::Point, ShadowKind::Hard);
  const auto unshadowed = MakeLight(LightKind::Spot, ShadowKind::None);
  shadowed->SetDiffuseColor(0.25, 0.5, 0.0);
  shadowed->SetSpecularColor(0.0, 0.0, 0.0);
  other->SetDiffuseColor(0.0, 0.0, 0.0);
  other->SetSpecularColor(1.0, 0.0, 0.0);
  LightsAndMaterial scene({ shadowed, other, unshadowed });
  scene.property->SetDiffuse(0.6);
  scene.property->SetSpecular(0.4);
  LightingRequirements requirements;
  requirements.Optics = OpticalModel::SingleScattering;
  requirements
    .Lights[static_cast<int>(LightKind::Directional)][static_cast<int>(ShadowKind::Soft)] = 1;
  requirements.Lights[static_cast<int>(LightKind::Point)][static_cast<int>(ShadowKind::Hard)] = 1;
  requirements.Lights[static_cast<int>(LightKind::Spot)][static_cast<int>(ShadowKind::None)] = 1;
  const double brightness = MakeUniforms(scene).GetShadowedBrightness(requirements);
  CHECK(brightness == Approx(std::sqrt(0.3 * 0.3 + 0.4 * 0.4)));
}
