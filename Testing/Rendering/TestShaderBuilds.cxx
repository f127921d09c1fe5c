#include "Catch.h"
#include "SceneOptions.h"

#include <vtkCamera.h>
#include <vtkVolumeProperty.h>

#include <functional>

using namespace penumbra;

namespace
{
struct SceneChange
{
  const char* name;
  std::function<void(IlluminatedScene&)> change;
};

const std::vector<SceneChange> UniformChanges = {
  { "diffuse colour",
    [](IlluminatedScene& scene) { scene.GetLight()->SetDiffuseColor(1.0, 0.0, 0.5); } },
  { "specular colour",
    [](IlluminatedScene& scene) { scene.GetLight()->SetSpecularColor(0.0, 0.0, 0.5); } },
  { "ambient colour",
    [](IlluminatedScene& scene) { scene.GetLight()->SetAmbientColor(0.0, 0.0, 0.0); } },
  { "intensity", [](IlluminatedScene& scene) { scene.GetLight()->SetIntensity(0.9); } },
  { "place", [](IlluminatedScene& scene) { scene.GetLight()->SetPosition(-20.0, 3.0, 7.0); } },
  { "cone", [](IlluminatedScene& scene) { scene.GetLight()->SetConeAngle(50.0); } },
  { "attenuation",
    [](IlluminatedScene& scene) { scene.GetLight()->SetAttenuationValues(1.0, 0.02, 0.0); } },
  { "bias", [](IlluminatedScene& scene) { scene.GetLight()->SetShadowBias(2.0); } },
  { "threshold", [](IlluminatedScene& scene) { scene.GetLight()->SetOpacityThreshold(0.3); } },
  { "camera", [](IlluminatedScene& scene) { scene.Renderer->GetActiveCamera()->Azimuth(40.0); } },
  { "opacity function", [](IlluminatedScene& scene) { scene.Opacity->AddPoint(100.0, 0.4); } },
  { "colour function",
    [](IlluminatedScene& scene) { scene.Color->AddRGBPoint(90.0, 0.0, 1.0, 0.0); } },
  { "material",
    [](IlluminatedScene& scene)
    {
      scene.Volume->GetProperty()->SetAmbient(0.0);
      scene.Volume->GetProperty()->SetDiffuse(0.2);
      scene.Volume->GetProperty()->SetSpecular(0.9);
      scene.Volume->GetProperty()->SetSpecularPower(3.0);
    } },
  { "volume's place", [](IlluminatedScene& scene) { scene.Volume->SetPosition(1.0, 0.0, 0.0); } },
  { "steps", [](IlluminatedScene& scene) { scene.Mapper->SetSampleDistance(0.4f); } },
};

const std::vector<SceneChange> ProgramChanges = {
  { "hard shadow", [](IlluminatedScene& scene) { scene.GetLight()->SetShadowToHard(); } },
  { "no shadow", [](IlluminatedScene& scene) { scene.GetLight()->SetShadowToNone(); } },
  { "point light", [](IlluminatedScene& scene) { scene.GetLight()->SetConeAngle(90.0); } },
  { "directional light", [](IlluminatedScene& scene) { scene.GetLight()->PositionalOff(); } },
  { "no specular term",
    [](IlluminatedScene& scene) { scene.Volume->GetProperty()->SetSpecular(0.0); } },
  { "no light", [](IlluminatedScene& scene) { scene.GetLight()->SwitchOff(); } },
  { "no shading", [](IlluminatedScene& scene) { scene.Shade(false); } },
  { "cropping", [](IlluminatedScene& scene) { scene.Mapper->CroppingOn(); } },
};

// One spot light with a soft shadow.
std::unique_ptr<IlluminatedScene> MakeSpotScene()
{
  SceneOptions options;
  options.lights[static_cast<int>(LightKind::Spot)][static_cast<int>(ShadowKind::Soft)] = 1;
  options.gradientOpacity = options.mask = options.gathering = false;
  options.clippingPlanes = 0;
  options.cropping = CroppingKind::None;
  options.opacity = TransferFunctionLookup::Table;
  auto scene = MakeScene();
  SetOptions(*scene, options);
  return scene;
}
}

TEST_CASE("Colours, places, factors, functions and the camera change uniforms only")
{
  const auto scene = MakeSpotScene();
  scene->Render();
  REQUIRE(scene->Mapper->GetNumberOfShaderBuilds() == 1);
  for (const SceneChange& change : UniformChanges)
  {
    INFO(change.name);
    change.change(*scene);
    scene->Render();
    CHECK(scene->Mapper->GetNumberOfShaderBuilds() == 1);
  }
}

TEST_CASE("A light's kind and shadow, and all else that is needed or not, change the program once")
{
  const auto scene = MakeSpotScene();
  scene->Render();
  int builds = 1;
  for (const SceneChange& change : ProgramChanges)
  {
    INFO(change.name);
    change.change(*scene);
    scene->Render();
    CHECK(scene->Mapper->GetNumberOfShaderBuilds() == ++builds);
    scene->Render();
    CHECK(scene->Mapper->GetNumberOfShaderBuilds() == builds);
  }
}
