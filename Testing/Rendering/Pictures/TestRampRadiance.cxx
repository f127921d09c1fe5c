#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <memory>

using namespace penumbra;

namespace
{
constexpr double Diffuse = 0.7;
constexpr double Red = 0.9;

// Scalars rise along z, 128 voxels deep; each voxel has an opacity of 0.1. So wide that every ray
// enters by its front, at high z. The light's direction makes the given angle with the gradient.
std::unique_ptr<IlluminatedScene> MakeRampScene(double lightAngle, int shadow)
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 128 };
  grid.spacing = { 2000.0, 2000.0, 1.0 };
  grid.scalarType = VTK_FLOAT;
  auto scene = std::make_unique<IlluminatedScene>(MakeRamp(grid, 2), 32, 32);
  scene->Renderer->SetBackground(0.0, 0.0, 0.0);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.1);
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(0.0, Red, 0.5, 0.3);
  vtkVolumeProperty* property = scene->Volume->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(Diffuse);
  property->SetSpecular(0.0);
  const double angle = vtkMath::RadiansFromDegrees(lightAngle);
  scene->AddDirectionalLight(std::sin(angle), 0.0, -std::cos(angle), shadow)->SetShadowBias(0.0);
  return scene;
}

double GetRed(IlluminatedScene& scene, double viewAngle)
{
  const double center[3] = { 2000.0, 2000.0, 127.0 };
  const double angle = vtkMath::RadiansFromDegrees(viewAngle);
  scene.LookFrom(0.0, std::sin(angle), std::cos(angle), 400.0, center);
  scene.Renderer->GetActiveCamera()->SetViewAngle(10.0);
  return scene.Render()->GetScalarComponentAsDouble(16, 16, 0, 0) / 255.0;
}
}

// Half a grey level of rounding is 0.3 % of these values.
constexpr double OnePercent = 0.01;

TEST_CASE("Ramp: unshadowed, neither the step nor the direction of view matters", "[ramp]")
{
  const double step = GENERATE(0.25, 0.5, 1.0, 2.0);
  const double viewAngle = GENERATE(0.0, 30.0, 60.0);
  auto scene = MakeRampScene(0.0, vtkVolumeLight::None);
  scene->Mapper->SetSampleDistance(static_cast<float>(step));
  CHECK(GetRed(*scene, viewAngle) == Approx(Red * Diffuse).epsilon(OnePercent));
}

// L = integral of s exp(-s t) exp(-s t cos v / cos l) dt, over the depth t along the view ray.
TEST_CASE("Ramp: a soft shadow dims by 1 / (1 + cos v / cos l)", "[ramp]")
{
  const double step = GENERATE(0.25, 0.5, 1.0);
  const double viewAngle = GENERATE(0.0, 30.0, 60.0);
  const double lightAngle = GENERATE(0.0, 45.0);
  auto scene = MakeRampScene(lightAngle, vtkVolumeLight::Soft);
  scene->Mapper->SetSampleDistance(static_cast<float>(step));
  scene->Mapper->SetShadowSampleDistance(step);
  const double cosLight = std::cos(vtkMath::RadiansFromDegrees(lightAngle));
  const double cosView = std::cos(vtkMath::RadiansFromDegrees(viewAngle));
  const double expected = Red * Diffuse * cosLight / (1.0 + cosView / cosLight);
  CHECK(GetRed(*scene, viewAngle) == Approx(expected).epsilon(OnePercent));
}

// Seen from the dark side: the light passes an optical depth of T - u to the depth u, so that
// c = min(k exp(u - T), 1) and L = integral of c exp(-u) du.
TEST_CASE("Ramp: a strong light's shadow is as deep as its strength needs", "[ramp]")
{
  constexpr double intensity = 1000.0;
  auto scene = MakeRampScene(0.0, vtkVolumeLight::Soft);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.08);
  scene->GetLight()->SetIntensity(intensity);
  scene->Mapper->SetSampleDistance(0.25f);
  scene->Mapper->SetShadowSampleDistance(0.25);
  const double strength = intensity * Diffuse * Red;
  const double depth = -127.0 * std::log(1.0 - 0.08);
  const double saturated = depth - std::log(strength);
  const double expected =
    strength * std::exp(-depth) * saturated + std::exp(-saturated) - std::exp(-depth);
  // From behind, along the gradient; half a grey level of rounding and the steps.
  CHECK(GetRed(*scene, 180.0) == Approx(expected).margin(0.6 / 255.0).epsilon(OnePercent));
}
