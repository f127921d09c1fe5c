#include "Catch.h"
#include "vtkVolumeLight.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <sstream>
#include <vector>

using Triple = std::array<double, 3>;

namespace
{
Triple ToTriple(const double* values)
{
  return { values[0], values[1], values[2] };
}

void SetEverything(vtkVolumeLight* light)
{
  light->SetAmbientColor(0.1, 0.2, 0.3);
  light->SetDiffuseColor(0.4, 0.5, 0.6);
  light->SetSpecularColor(0.7, 0.8, 0.9);
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(4.0, 5.0, 6.0);
  light->SetIntensity(0.25);
  light->SwitchOff();
  light->PositionalOn();
  light->SetExponent(7.0);
  light->SetConeAngle(33.0);
  light->SetAttenuationValues(2.0, 3.0, 4.0);
  light->SetLightTypeToCameraLight();
  light->SetShadowAttenuation(0.75f);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 17.0);
  light->SetTransformMatrix(matrix);
  light->SetShadowToHard();
  light->SetOpacityThreshold(0.5);
  light->SetShadowBias(0.125);
}
}

TEST_CASE("A volume light casts no shadow by default and has a white ambient colour")
{
  vtkNew<vtkVolumeLight> light;
  CHECK(light->GetShadow() == vtkVolumeLight::None);
  CHECK(light->GetOpacityThreshold() == 0.95);
  CHECK(light->GetShadowBias() == -1.0);
  CHECK(ToTriple(light->GetAmbientColor()) == Triple{ 1.0, 1.0, 1.0 });
  CHECK(ToTriple(light->GetDiffuseColor()) == Triple{ 1.0, 1.0, 1.0 });
  CHECK(ToTriple(light->GetSpecularColor()) == Triple{ 1.0, 1.0, 1.0 });
  CHECK(light->GetSwitch() == 1);
}

TEST_CASE("Shadow states have names, and out of range values are clamped")
{
  vtkNew<vtkVolumeLight> light;
  CHECK(std::string(light->GetShadowAsString()) == "None");
  light->SetShadowToSoft();
  CHECK(std::string(light->GetShadowAsString()) == "Soft");
  light->SetShadow(7);
  CHECK(std::string(light->GetShadowAsString()) == "Hard");
  light->SetShadow(-1);
  CHECK(light->GetShadow() == vtkVolumeLight::None);
  light->SetOpacityThreshold(2.0);
  CHECK(light->GetOpacityThreshold() == 1.0);
  light->SetOpacityThreshold(-2.0);
  CHECK(light->GetOpacityThreshold() == 0.0);
}

TEST_CASE("A shallow clone keeps the class and everything of a light")
{
  vtkNew<vtkVolumeLight> light;
  SetEverything(light);
  const auto plain = vtkSmartPointer<vtkLight>::Take(light->ShallowClone());
  auto* clone = vtkVolumeLight::SafeDownCast(plain);
  REQUIRE(clone);
  CHECK(ToTriple(clone->GetAmbientColor()) == Triple{ 0.1, 0.2, 0.3 });
  CHECK(ToTriple(clone->GetDiffuseColor()) == Triple{ 0.4, 0.5, 0.6 });
  CHECK(ToTriple(clone->GetSpecularColor()) == Triple{ 0.7, 0.8, 0.9 });
  CHECK(ToTriple(clone->GetPosition()) == Triple{ 1.0, 2.0, 3.0 });
  CHECK(ToTriple(clone->GetFocalPoint()) == Triple{ 4.0, 5.0, 6.0 });
  CHECK(clone->GetIntensity() == 0.25);
  CHECK(clone->GetSwitch() == 0);
  CHECK(clone->GetPositional() == 1);
  CHECK(clone->GetExponent() == 7.0);
  CHECK(clone->GetConeAngle() == 33.0);
  CHECK(ToTriple(clone->GetAttenuationValues()) == Triple{ 2.0, 3.0, 4.0 });
  CHECK(clone->LightTypeIsCameraLight());
  CHECK(clone->GetShadowAttenuation() == 0.75f);
  CHECK(clone->GetTransformMatrix() == light->GetTransformMatrix());
  CHECK(clone->GetShadow() == vtkVolumeLight::Hard);
  CHECK(clone->GetOpacityThreshold() == 0.5);
  CHECK(clone->GetShadowBias() == 0.125);
}

TEST_CASE("Every member of a volume light changes its modification time, once")
{
  const std::vector<std::function<void(vtkVolumeLight*)>> changes = {
    [](vtkVolumeLight* light) { light->SetShadowToSoft(); },
    [](vtkVolumeLight* light) { light->SetOpacityThreshold(0.25); },
    [](vtkVolumeLight* light) { light->SetShadowBias(2.0); },
  };
  vtkNew<vtkVolumeLight> light;
  for (const auto& change : changes)
  {
    const vtkMTimeType before = light->GetMTime();
    change(light);
    const vtkMTimeType changed = light->GetMTime();
    CHECK(changed > before);
    change(light);
    CHECK(light->GetMTime() == changed);
  }
}

TEST_CASE("A volume light prints every member")
{
  vtkNew<vtkVolumeLight> light;
  SetEverything(light);
  std::ostringstream text;
  light->Print(text);
  CHECK_THAT(text.str(), Catch::Matchers::ContainsSubstring("Shadow: Hard\n"));
  CHECK_THAT(text.str(), Catch::Matchers::ContainsSubstring("OpacityThreshold: 0.5\n"));
  CHECK_THAT(text.str(), Catch::Matchers::ContainsSubstring("ShadowBias: 0.125\n"));
  CHECK_THAT(text.str(), Catch::Matchers::ContainsSubstring("Exponent: 7"));
}
