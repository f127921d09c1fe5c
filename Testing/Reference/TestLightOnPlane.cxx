#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkColorTransferFunction.h>
#include <vtkMath.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double HeightOfPlane = 5.0;
constexpr double Close = 1e-5;
}

TEST_CASE("A point light's light falls off with the square of its distance")
{
  ReferenceScene scene = MakePlaneScene();
  const Point position = { 1.0, -2.0, HeightOfPlane + 3.0 };
  const auto light = MakePointLight(position);
  light->SetAttenuationValues(0.0, 0.0, 0.2);
  scene.Lights = { light };
  for (const auto& [x, y] : { std::pair(1.0, -2.0), std::pair(3.0, 2.0), std::pair(-5.5, 6.0) })
  {
    const double distance = std::hypot(x - position[0], y - position[1], 3.0);
    const double attenuation = std::min(1.0 / (0.2 * distance * distance), 1.0);
    CHECK(ComputePlane(scene, x, y)[0] == Approx(attenuation * 3.0 / distance).margin(Close));
  }
  // Nothing brightens, and a denominator that is not positive does not count.
  light->SetAttenuationValues(0.0, 0.0, 0.01);
  CHECK(ComputePlane(scene, 1.0, -2.0)[0] == Approx(1.0).margin(Close));
  light->SetAttenuationValues(0.0, -1.0, 0.0);
  CHECK(ComputePlane(scene, 1.0, -2.0)[0] == Approx(1.0).margin(Close));
}

TEST_CASE("Attenuation is measured in the world, however large the volume is made")
{
  ReferenceScene scene = MakePlaneScene();
  scene.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  scene.Transform->SetElement(2, 2, 2.0);
  const auto light = MakePointLight({ 0.0, 0.0, 2.0 * HeightOfPlane + 4.0 });
  light->SetAttenuationValues(1.0, 0.5, 0.0);
  scene.Lights = { light };
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == Approx(1.0 / 3.0).margin(Close));
}

TEST_CASE("A spot light shines within its cone, by its exponent")
{
  ReferenceScene scene = MakePlaneScene();
  const auto light = MakePointLight({ 0.0, 0.0, HeightOfPlane + 4.0 });
  light->SetConeAngle(40.0);
  light->SetExponent(3.0);
  scene.Lights = { light };
  const double edge = 4.0 * std::tan(vtkMath::RadiansFromDegrees(40.0));
  const double cosine = 4.0 / std::hypot(4.0, 3.0);
  CHECK(ComputePlane(scene, 3.0, 0.0)[0] == Approx(std::pow(cosine, 4.0)).margin(Close));
  CHECK(ComputePlane(scene, edge - 1e-6, 0.0)[0] > 0.1);
  CHECK(ComputePlane(scene, 0.0, -edge - 1e-6)[0] == 0.0);
  light->SetConeAngle(90.0);
  CHECK(ComputePlane(scene, 8.0, 0.0)[0] == Approx(4.0 / std::hypot(4.0, 8.0)).margin(Close));
}

TEST_CASE("A surface is lit on its outer side, or on both")
{
  ReferenceScene scene = MakePlaneScene();
  const auto light = MakeDirectionalLight({ 0.6, 0.0, 0.8 });
  scene.Lights = { light };
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == 0.0);
  scene.TwoSidedLighting = true;
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == Approx(0.8).margin(Close));
}

TEST_CASE("Colours, intensity and the material's factors multiply")
{
  ReferenceScene scene = MakePlaneScene();
  scene.Property->SetAmbient(0.5);
  scene.Property->SetDiffuse(0.7);
  scene.Property->SetSpecular(0.25);
  scene.Property->SetSpecularPower(8.0);
  vtkNew<vtkColorTransferFunction> orange;
  orange->AddRGBPoint(0.0, 1.0, 0.5, 0.25);
  scene.Property->SetColor(orange);
  const auto light = MakeDirectionalLight({ 0.28, 0.0, -0.96 });
  light->SetIntensity(0.5);
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetDiffuseColor(0.4, 0.8, 1.0);
  light->SetSpecularColor(1.0, 0.5, 0.0);
  scene.Lights = { light, MakeDirectionalLight({ 0.0, 0.0, 1.0 }) };
  scene.Lights[1]->SwitchOff();
  const auto color = ComputePlane(scene, 0.0, 0.0);
  for (int channel = 0; channel < 3; ++channel)
  {
    const double matter = orange->GetColor(0.0)[channel];
    const double lobe = std::pow(0.96, 8.0);
    const double expected = 0.5 *
      (matter * 0.5 * light->GetAmbientColor()[channel] +
        matter * 0.7 * light->GetDiffuseColor()[channel] * 0.96 +
        0.25 * light->GetSpecularColor()[channel] * lobe);
    CHECK(color[channel] == Approx(expected).margin(Close));
  }
}

TEST_CASE("Plain black ambient light counts as white, and no light as none")
{
  ReferenceScene scene = MakePlaneScene();
  scene.Property->SetAmbient(0.5);
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == 0.0);
  vtkNew<vtkLight> plain;
  plain->SetLightTypeToSceneLight();
  plain->SetPosition(0.0, 0.0, -1.0);
  plain->SetIntensity(0.1);
  scene.Lights = { plain.Get() };
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == Approx(0.5).margin(Close));
  scene.Lights.emplace_back(MakeDirectionalLight({ 0.0, 0.0, 1.0 }));
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == 0.0);
}

TEST_CASE("Head lights and camera lights follow the camera")
{
  ReferenceScene scene = MakePlaneScene();
  const auto light = MakePointLight({ 0.6, 0.0, 0.8 });
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->PositionalOff();
  scene.Lights = { light };
  light->SetLightTypeToHeadlight();
  scene.Camera = MakeParallelCamera({ 0.0, 0.0, HeightOfPlane }, { 0.3, 0.4, -1.2 });
  CHECK(ComputeMiddle(scene).Color[0] == Approx(1.2 / 1.3).margin(Close));
  light->SetLightTypeToCameraLight();
  CHECK(ComputePlane(scene, 0.0, 0.0)[0] == Approx(0.8).margin(Close));
}
