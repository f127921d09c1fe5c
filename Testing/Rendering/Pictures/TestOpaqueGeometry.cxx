#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <memory>

using namespace penumbra;

namespace
{
constexpr double Center[3] = { 15.5, 15.5, 15.5 };

std::unique_ptr<IlluminatedScene> MakeScene(bool parallel)
{
  auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 32, 32, 32 } }, 13.0, 6.0), 96, 96);
  scene->AddDirectionalLight(-0.3, -0.4, -1.0, vtkVolumeLight::Soft);
  scene->LookFrom(0.0, 0.0, 1.0, 80.0, Center);
  scene->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  scene->Renderer->GetActiveCamera()->SetParallelScale(20.0);
  return scene;
}

// A wall of the background's colour, facing the camera, from the left of the view up to an x.
void AddWall(IlluminatedScene& scene, double z, double right = 200.0)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-200.0, -200.0, z);
  source->SetPoint1(right, -200.0, z);
  source->SetPoint2(-200.0, 200.0, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(mapper);
  wall->GetProperty()->LightingOff();
  wall->GetProperty()->SetColor(scene.Renderer->GetBackground());
  scene.Renderer->AddActor(wall);
}
}

// A wall hides what is behind it, as a clipping plane does, but its shadow rays still meet the
// matter there: the light comes from the front, so that none does.
TEST_CASE("Opaque geometry: a wall through the volume hides what is behind it", "[window]")
{
  const bool parallel = GENERATE(false, true);
  const double imageSampleDistance = GENERATE(1.0, 1.0001, 2.0, 0.5);
  auto clipped = MakeScene(parallel);
  clipped->Mapper->SetImageSampleDistance(imageSampleDistance);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 19.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  clipped->Mapper->AddClippingPlane(plane);
  auto walled = MakeScene(parallel);
  walled->Mapper->SetImageSampleDistance(imageSampleDistance);
  AddWall(*walled, 19.0);
  const ImageDifference difference = CompareImages(walled->Render(), clipped->Render());
  INFO("rmse " << difference.rmse << " largest " << difference.largest);
  // The depth buffer has 24 bits and the pictures 8.
  CHECK(difference.largest <= 1.0);
  CHECK(CompareImages(walled->Render(), MakeScene(parallel)->Render()).rmse > 1.0);
}

// Fewer or more rays than pixels only blur; the wall's edge stays where it is.
TEST_CASE("Opaque geometry: half a wall hides the same half with any number of rays", "[window]")
{
  const double imageSampleDistance = GENERATE(2.0, 0.5);
  auto full = MakeScene(false);
  AddWall(*full, 30.0, 12.0);
  const auto expected = full->Render();
  auto sampled = MakeScene(false);
  AddWall(*sampled, 30.0, 12.0);
  sampled->Mapper->SetImageSampleDistance(imageSampleDistance);
  const ImageDifference difference = CompareImages(sampled->Render(), expected);
  INFO("rmse " << difference.rmse << " ssim " << difference.ssim);
  CHECK(difference.ssim > 0.97);
}

// Lights too faint to see make the picture need several draws.
TEST_CASE("Opaque geometry: a picture in several draws meets it in every viewport", "[window]")
{
  auto scene = MakeScene(false);
  AddWall(*scene, 19.0);
  scene->Window->SetSize(192, 96);
  scene->Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  const auto single = scene->Render();
  for (int i = 0; i < 90; ++i)
  {
    auto* light = scene->AddDirectionalLight(0.1 * i, -0.4, -1.0, vtkVolumeLight::Soft);
    light->SetDiffuseColor(1e-9, 0.0, 0.0);
    light->SetSpecularColor(0.0, 0.0, 0.0);
    light->SetAmbientColor(0.0, 0.0, 0.0);
  }
  const auto several = scene->Render();
  CHECK(scene->Mapper->GetNumberOfDraws() > 1);
  CHECK(CompareImages(several, single).largest <= 1.0);
}

TEST_CASE("Opaque geometry: a wall in front hides all, one behind nothing", "[window]")
{
  const auto free = MakeScene(false)->Render();
  auto behind = MakeScene(false);
  AddWall(*behind, -20.0);
  CHECK(CompareImages(behind->Render(), free).largest == 0.0);
  auto inFront = MakeScene(false);
  AddWall(*inFront, 50.0);
  auto empty = MakeScene(false);
  empty->Volume->VisibilityOff();
  CHECK(CompareImages(inFront->Render(), empty->Render()).largest == 0.0);
}
