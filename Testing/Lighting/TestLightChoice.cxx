#include "Catch.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"

#include <vtkMatrix4x4.h>

#include <functional>
#include <vector>

using namespace penumbra;

namespace
{
using LightChange = std::function<void(vtkVolumeLight*)>;
}

TEST_CASE("A light that can brighten nothing is left out")
{
  const std::vector<LightChange> darkenings = {
    [](vtkVolumeLight* light) { light->SwitchOff(); },
    [](vtkVolumeLight* light) { light->SetIntensity(0.0); },
    [](vtkVolumeLight* light)
    {
      light->SetDiffuseColor(0.0, 0.0, 0.0);
      light->SetSpecularColor(0.0, 0.0, 0.0);
    },
  };
  const LightingRequirements without = LightsAndMaterial().Requirements();
  for (const LightChange& darken : darkenings)
  {
    const auto light = MakeLight(LightKind::Point, ShadowKind::Hard);
    light->SetAttenuationValues(1.0, 0.0, 0.01);
    LightsAndMaterial with({ light });
    REQUIRE(with.Requirements() != without);
    darken(light);
    CHECK(with.Requirements() == without);
  }
}

TEST_CASE("A light's terms count where both its colour and the material's factor do")
{
  const auto light = MakeLight(LightKind::Directional, ShadowKind::Soft);
  LightsAndMaterial with({ light });
  const LightingRequirements both = with.Requirements();
  CHECK((both.Diffuse && both.Specular));
  light->SetDiffuseColor(0.0, 0.0, 0.0);
  CHECK((!with.Requirements().Diffuse && with.Requirements().Specular));
  with.property->SetSpecular(0.0);
  CHECK(with.Requirements() == LightsAndMaterial().Requirements());
  light->SetDiffuseColor(0.0, 0.0, 1.0);
  CHECK((with.Requirements().Diffuse && !with.Requirements().Specular));
  // The other light's term is enough.
  const auto gleam = MakeLight(LightKind::Point, ShadowKind::None);
  gleam->SetDiffuseColor(0.0, 0.0, 0.0);
  light->SetSpecularColor(0.0, 0.0, 0.0);
  with.property->SetSpecular(0.1);
  with.lights->AddItem(gleam);
  CHECK((with.Requirements().Diffuse && with.Requirements().Specular));
}

TEST_CASE("Colour, place and all that is only a number leave requirements equal")
{
  const std::vector<LightChange> changes = {
    [](vtkVolumeLight* light) { light->SetDiffuseColor(0.1, 0.0, 0.0); },
    [](vtkVolumeLight* light) { light->SetSpecularColor(0.0, 0.1, 0.0); },
    [](vtkVolumeLight* light) { light->SetAmbientColor(0.0, 0.0, 0.0); },
    [](vtkVolumeLight* light) { light->SetIntensity(17.0); },
    [](vtkVolumeLight* light) { light->SetPosition(-1.0, -2.0, -3.0); },
    [](vtkVolumeLight* light) { light->SetFocalPoint(0.0, 0.0, 1.0); },
    [](vtkVolumeLight* light) { light->SetConeAngle(10.0); },
    [](vtkVolumeLight* light) { light->SetExponent(0.0); },
    [](vtkVolumeLight* light) { light->SetAttenuationValues(2.0, 0.0, 0.0); },
    [](vtkVolumeLight* light) { light->SetOpacityThreshold(0.1); },
    [](vtkVolumeLight* light) { light->SetShadowBias(3.0); },
    [](vtkVolumeLight* light) { light->SetLightTypeToCameraLight(); },
    [](vtkVolumeLight* light) { light->SetTransformMatrix(vtkNew<vtkMatrix4x4>()); },
  };
  const auto light = MakeLight(LightKind::Spot, ShadowKind::Soft);
  light->SetAttenuationValues(1.0, 0.0, 0.5);
  LightsAndMaterial with({ light });
  const LightingRequirements before = with.Requirements();
  for (const LightChange& change : changes)
  {
    change(light);
    CHECK(with.Requirements() == before);
  }
  light->SetShadowToHard();
  CHECK(with.Requirements() != before);
}
