#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkVolumeProperty.h>

#include <memory>

using namespace penumbra;

namespace
{
struct Placement
{
  double Scale = 1.0;
  double Offset = 0.0;
};

// Everything that has a length is scaled; everything that has a place is moved.
std::unique_ptr<IlluminatedScene> MakeScene(const Placement& placement)
{
  const double scale = placement.Scale;
  const double offset = placement.Offset;
  VolumeGrid grid;
  grid.dimensions = { 32, 32, 20 };
  grid.spacing = { scale, scale, 1.6 * scale };
  grid.origin = { offset, -offset, offset };
  auto scene = std::make_unique<IlluminatedScene>(MakeShells(grid, 12.0 * scale), 96, 96);
  scene->Volume->GetProperty()->SetScalarOpacityUnitDistance(2.0 * scale);
  scene->Mapper->SetSampleDistance(static_cast<float>(0.4 * scale));
  scene->Mapper->SetShadowSampleDistance(0.8 * scale);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft)->SetShadowBias(scale);
  auto* point = scene->AddPointLight(
    offset + 30.0 * scale, -offset + 50.0 * scale, offset + 60.0 * scale, vtkVolumeLight::Hard);
  point->SetShadowBias(1.5 * scale);
  point->SetIntensity(0.5);
  return scene;
}
}

// Decimal factors round differently in single precision, which may tip a sample over an edge.
TEST_CASE("Invariance: scaling the whole scene gives the same picture", "[invariance]")
{
  const double scale = GENERATE(1e-3, 1e3);
  const ImageDifference difference =
    CompareImages(MakeScene({ scale, 0.0 })->Render(), MakeScene({})->Render());
  INFO("rmse " << difference.rmse << " largest " << difference.largest);
  CHECK(difference.rmse < 0.15);
  CHECK(difference.ssim > 0.9995);
}

TEST_CASE("Invariance: far from the origin the picture is the same", "[invariance]")
{
  const ImageDifference difference =
    CompareImages(MakeScene({ 1.0, 1e5 })->Render(), MakeScene({})->Render());
  INFO("rmse " << difference.rmse << " largest " << difference.largest);
  CHECK(difference.rmse < 0.15);
  CHECK(difference.ssim > 0.9995);
}

// More draws than one gather in floats what one draw sums in floats.
TEST_CASE("Invariance: a picture in several draws is the same picture", "[invariance]")
{
  auto scene = MakeScene({});
  const auto single = scene->Render();
  REQUIRE(scene->Mapper->GetNumberOfDraws() == 1);
  auto several = MakeScene({});
  // The same steps, but the bound on a draw's iterations now counts many more lights.
  for (int i = 0; i < 40; ++i)
  {
    auto* light = several->AddDirectionalLight(0.3, -1.0, 0.1 * i, vtkVolumeLight::Soft);
    light->SetDiffuseColor(1e-9, 0.0, 0.0);
    light->SetSpecularColor(0.0, 0.0, 0.0);
    light->SetAmbientColor(0.0, 0.0, 0.0);
  }
  const auto picture = several->Render();
  CHECK(several->Mapper->GetNumberOfDraws() > 1);
  CHECK(CompareImages(picture, single).largest <= 1.0);
}

TEST_CASE("Invariance: lights add up", "[invariance]")
{
  auto one = MakeScene({});
  auto many = MakeScene({});
  many->GetLight()->SwitchOff();
  for (int i = 0; i < 32; ++i)
  {
    auto* light = many->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
    light->SetShadowBias(1.0);
    light->SetIntensity(1.0 / 32.0);
  }
  CHECK(CompareImages(many->Render(), one->Render()).largest <= 1.0);
  CHECK(many->Mapper->GetRequirements().GetNumberOfLights() == 33);
}

TEST_CASE("Invariance: lights beyond what a shader holds are told, and the picture is not blank",
  "[invariance]")
{
  auto scene = MakeScene({});
  scene->Volume->GetProperty()->SetAmbient(0.0);
  const auto before = scene->Render();
  scene->Mapper->GlobalWarningDisplayOff();
  for (int i = 0; i < 3000; ++i)
  {
    auto* light = scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::None);
    light->SetIntensity(1e-6);
  }
  const auto picture = scene->Render();
  REQUIRE(scene->Mapper->GetMessages().size() == 1);
  CHECK(scene->Mapper->GetMessages()[0].find("lights") != std::string::npos);
  CHECK(scene->Mapper->GetRequirements().GetNumberOfLights() >= 32);
  CHECK(CompareImages(picture, before).largest <= 2.0);
}
