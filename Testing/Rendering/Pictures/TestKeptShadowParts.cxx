#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
std::unique_ptr<IlluminatedScene> MakeScene(int technique)
{
  auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 24, 24, 24 } }, 9.0, 4.0), 32, 32);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  scene->AddPointLight(30.0, 30.0, 30.0, vtkVolumeLight::Hard);
  scene->Mapper->SetShadowTechnique(technique);
  return scene;
}

constexpr int MostFrames = 1000;

// Returns how many frames had no volume yet.
int RenderUntilComplete(IlluminatedScene& scene)
{
  int frames = 0;
  scene.Render();
  while (!scene.Mapper->GetShadowsComplete() && frames < MostFrames)
  {
    ++frames;
    scene.Render();
  }
  return frames;
}
}

TEST_CASE("Kept shadows: what is computed part by part is what is computed at once")
{
  const int technique =
    GENERATE(vtkIlluminatedVolumeMapper::Volume, vtkIlluminatedVolumeMapper::OpacityMap);
  CAPTURE(technique);
  auto atOnce = MakeScene(technique);
  const auto expected = atOnce->Render();
  CHECK(atOnce->Mapper->GetShadowsComplete());

  auto scene = MakeScene(technique);
  scene->Mapper->SetShadowUpdateTime(1e-9);
  const auto nothing = scene->Render();
  CHECK_FALSE(scene->Mapper->GetShadowsComplete());
  CHECK(CompareImages(nothing, expected).rmse > 10.0);
  CHECK(RenderUntilComplete(*scene) > 4);
  CHECK(CompareImages(scene->Render(), expected).rmse == 0.0);
  CHECK(scene->Mapper->GetNumberOfShadowUpdates() == 2);
}

TEST_CASE("Kept shadows: a change while they are incomplete begins anew")
{
  const int technique =
    GENERATE(vtkIlluminatedVolumeMapper::Volume, vtkIlluminatedVolumeMapper::OpacityMap);
  CAPTURE(technique);
  auto scene = MakeScene(technique);
  const auto expected = scene->Render();
  scene->Mapper->SetShadowUpdateTime(1e-9);
  vtkVolumeLight* light = scene->GetLight();
  double before[3];
  light->GetFocalPoint(before);
  light->SetFocalPoint(-0.5, 0.3, 1.0);
  scene->Render();
  scene->Render();
  CHECK_FALSE(scene->Mapper->GetShadowsComplete());
  light->SetFocalPoint(before); // whose shadow is half overwritten
  CHECK(RenderUntilComplete(*scene) > 1);
  CHECK(CompareImages(scene->Render(), expected).rmse == 0.0);

  light->SetFocalPoint(-0.5, 0.3, 1.0);
  scene->Render();
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.0);
  CHECK(RenderUntilComplete(*scene) < MostFrames); // even where nothing is visible
}
