#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkVolumeProperty.h>

#include <functional>
#include <memory>
#include <string>

using namespace penumbra;

namespace
{
// Large enough for rays to be dear. Its opacities are those of a unit distance of one voxel.
std::unique_ptr<IlluminatedScene> MakeScene(double voxel = 1.0, double opacity = 0.6)
{
  const auto image = MakeShells({ { 64, 64, 64 }, { voxel, voxel, voxel } }, 22.0 * voxel);
  auto scene = std::make_unique<IlluminatedScene>(image, 192, 192);
  scene->Mapper->SetShadowTechniqueToAuto();
  scene->Mapper->SetSampleDistance(static_cast<float>(0.5 * voxel));
  scene->Volume->GetProperty()->SetScalarOpacityUnitDistance(voxel);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(60.0, 0.0);
  scene->Opacity->AddPoint(255.0, opacity);
  return scene;
}

void AddLight(IlluminatedScene& scene, int shadow = vtkVolumeLight::Soft)
{
  scene.AddDirectionalLight(-0.6, -0.7, -0.4, shadow);
}

std::string ChoiceOf(IlluminatedScene& scene)
{
  scene.Render();
  return scene.Mapper->GetShadowTechniqueReason() + ", " +
    std::to_string(scene.Mapper->GetActualShadowNearSteps());
}

// Of the picture, from rays of half the step.
double ErrorOf(IlluminatedScene& scene)
{
  const auto picture = scene.Render();
  scene.Mapper->SetShadowTechniqueToRays();
  scene.Mapper->SetShadowSampleDistance(0.5);
  const double error = CompareImages(picture, scene.Render()).rmse;
  scene.Mapper->SetShadowTechniqueToAuto();
  scene.Mapper->SetShadowSampleDistance(0.0);
  return error;
}
}

TEST_CASE("Auto: shadows are kept, and within the tolerance")
{
  const auto addLights = GENERATE(values<std::function<void(IlluminatedScene&)>>({
    [](IlluminatedScene& s) { AddLight(s); },
    [](IlluminatedScene& s) { s.AddPointLight(60.0, 50.0, 60.0, vtkVolumeLight::Soft); },
    [](IlluminatedScene& s)
    {
      for (const double x : { -1.0, -0.3, 0.3, 1.0 })
      {
        s.AddDirectionalLight(x, -0.7, -0.4, vtkVolumeLight::Soft)->SetIntensity(0.25);
      }
    },
  }));
  const double opacity = GENERATE(0.02, 0.1, 0.6);
  auto scene = MakeScene(1.0, opacity);
  addLights(*scene);
  const double error = ErrorOf(*scene);
  scene->Render();
  INFO(scene->Mapper->GetShadowTechniqueReason());
  CHECK(scene->Mapper->GetShadowBytes() > 0);
  CHECK(error <= scene->Mapper->GetShadowTolerance());
}

TEST_CASE("Auto: a smaller tolerance brings the picture nearer to the rays'")
{
  auto scene = MakeScene();
  AddLight(*scene);
  const double error = ErrorOf(*scene);
  scene->Mapper->SetShadowTolerance(0.3);
  CHECK(ErrorOf(*scene) < 0.8 * error);
}

TEST_CASE("Auto: hard shadows ask for more than soft ones")
{
  auto soft = MakeScene();
  AddLight(*soft);
  auto hard = MakeScene();
  AddLight(*hard, vtkVolumeLight::Hard);
  CHECK(ChoiceOf(*hard) != ChoiceOf(*soft));
}

TEST_CASE("Auto: the choice knows no unit of length")
{
  const double voxel = GENERATE(1e-4, 30.0);
  auto scene = MakeScene(voxel);
  AddLight(*scene);
  auto ofUnitVoxels = MakeScene();
  AddLight(*ofUnitVoxels);
  CHECK(ChoiceOf(*scene) == ChoiceOf(*ofUnitVoxels));
}

TEST_CASE("Auto: the choice is the same wherever the camera is")
{
  auto scene = MakeScene();
  AddLight(*scene);
  const std::string before = ChoiceOf(*scene);
  const int updates = scene->Mapper->GetNumberOfShadowUpdates();
  vtkCamera* camera = scene->Renderer->GetActiveCamera();
  camera->Azimuth(70.0);
  camera->Zoom(3.0);
  scene->Renderer->ResetCameraClippingRange();
  CHECK(ChoiceOf(*scene) == before);
  CHECK(scene->Mapper->GetNumberOfShadowUpdates() == updates);
}

TEST_CASE("Auto: light half as bright leaves half the error")
{
  const auto predict = [](IlluminatedScene& scene)
  {
    const std::string told = "predicted error of ";
    const std::string reason = ChoiceOf(scene);
    REQUIRE(reason.rfind(told, 0) == 0);
    return std::stod(reason.substr(told.size()));
  };
  auto scene = MakeScene();
  AddLight(*scene);
  const double before = predict(*scene);
  scene->GetLight()->SetIntensity(0.5);
  // Two digits are told.
  CHECK(predict(*scene) == Approx(0.5 * before).margin(0.01));
}

TEST_CASE("Auto: thin matter needs less memory")
{
  auto scene = MakeScene();
  AddLight(*scene);
  scene->Render();
  const std::size_t before = scene->Mapper->GetShadowBytes();
  scene->Opacity->AddPoint(255.0, 0.05);
  scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() > 0);
  CHECK(scene->Mapper->GetShadowBytes() < before / 10);
}
