#include "Catch.h"
#include "KeptShadowDifference.h"
#include "SyntheticVolumes.h"

#include <vtkLightCollection.h>
#include <vtkPlane.h>

#include <functional>
#include <memory>

using namespace penumbra;

namespace
{
using Mapper = vtkIlluminatedVolumeMapper;

struct Case
{
  std::string name;
  std::function<void(IlluminatedScene&)> arrange;
};

void AddSpot(IlluminatedScene& scene, int shadow)
{
  vtkVolumeLight* light = scene.AddPointLight(60.0, 70.0, 60.0, shadow);
  light->SetFocalPoint(24.0, 24.0, 24.0);
  light->SetConeAngle(20.0);
}

void Clip(IlluminatedScene& scene)
{
  scene.AddDirectionalLight(-0.2, -0.2, -1.0, vtkVolumeLight::Soft);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(24.0, 24.0, 30.0);
  plane->SetNormal(0.1, 0.2, -1.0);
  scene.Mapper->AddClippingPlane(plane);
}

void Crop(IlluminatedScene& scene)
{
  scene.AddDirectionalLight(-0.2, -0.2, -1.0, vtkVolumeLight::Soft);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(10.0, 40.0, 5.0, 40.0, 0.0, 28.0);
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
}

void Mask(IlluminatedScene& scene)
{
  scene.AddDirectionalLight(-0.2, -0.2, -1.0, vtkVolumeLight::Soft);
  scene.Mapper->SetMaskInput(
    SampleField({ { 48, 48, 48 } }, [](const Point& p) { return p[2] < 29.5 ? 1.0 : 0.0; }));
  scene.Mapper->SetMaskTypeToBinary();
}

void FiveLights(IlluminatedScene& scene)
{
  scene.AddDirectionalLight(-1.0, -0.5, -0.5, vtkVolumeLight::Soft);
  scene.AddDirectionalLight(1.0, -0.5, -0.5, vtkVolumeLight::Soft);
  scene.AddDirectionalLight(0.1, 1.0, -0.5, vtkVolumeLight::Soft);
  scene.AddPointLight(24.0, 24.0, 60.0, vtkVolumeLight::Soft);
  AddSpot(scene, vtkVolumeLight::Soft);
  for (int light = 0; light < 5; ++light)
  {
    vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(light))->SetIntensity(0.4);
  }
}

const std::vector<Case> SoftCases = {
  { "directional",
    [](IlluminatedScene& s) { s.AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft); } },
  { "along an axis",
    [](IlluminatedScene& s) { s.AddDirectionalLight(0.0, -1.0, 0.0, vtkVolumeLight::Soft); } },
  { "point inside",
    [](IlluminatedScene& s) { s.AddPointLight(30.0, 30.0, 38.0, vtkVolumeLight::Soft); } },
  { "spot", [](IlluminatedScene& s) { AddSpot(s, vtkVolumeLight::Soft); } },
  { "five lights", FiveLights },
  { "clipped", Clip },
  { "cropped", Crop },
  { "masked", Mask },
};

std::unique_ptr<IlluminatedScene> MakeScene(const Case& example)
{
  auto scene = std::make_unique<IlluminatedScene>(MakeShells({ { 48, 48, 48 } }, 16.0));
  scene->Mapper->SetSampleDistance(0.5f);
  example.arrange(*scene);
  return scene;
}
}

TEST_CASE("Kept shadows: soft shadows of all lights are the rays' within a grey level")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  for (const Case& example : SoftCases)
  {
    INFO(example.name << " by technique " << technique);
    auto scene = MakeScene(example);
    const ImageDifference difference = DifferenceFromRays(*scene, technique);
    INFO("rmse " << difference.rmse << ", largest " << difference.largest);
    CHECK(difference.rmse <= 1.0);
    // Nowhere a leak, a dark rim or a band: a shadow missed is worth a hundred. Rays of a deep map
    // beside a cut end differ from those that meet it.
    CHECK(difference.largest <= (technique == Mapper::DeepMap ? 30.0 : 12.0));
  }
}

TEST_CASE("Kept shadows: steps marched directly bring the shadows nearer to the rays'")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  auto scene = MakeScene(SoftCases.front());
  scene->Mapper->SetShadowResolution(0.5);
  scene->Mapper->SetShadowNearSteps(0);
  const double without = DifferenceFromRays(*scene, technique).rmse;
  scene->Mapper->SetShadowNearSteps(4);
  CHECK(DifferenceFromRays(*scene, technique).rmse < 0.6 * without);
  // All steps marched directly are the rays themselves.
  scene->Mapper->SetShadowNearSteps(1000);
  CHECK(DifferenceFromRays(*scene, technique).largest == 0.0);
}

TEST_CASE("Kept shadows: hard shadows differ along their edge only")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::Map, Mapper::DeepMap, Mapper::OpacityMap);
  const auto arrange = GENERATE(values<std::function<void(IlluminatedScene&)>>({
    [](IlluminatedScene& s) { s.AddDirectionalLight(-0.3, -1.0, -0.1, vtkVolumeLight::Hard); },
    [](IlluminatedScene& s) { s.AddPointLight(24.0, 46.0, 24.0, vtkVolumeLight::Hard); },
    [](IlluminatedScene& s) { AddSpot(s, vtkVolumeLight::Hard); },
  }));
  auto scene = MakeScene({ "hard", arrange });
  const ImageDifference difference = DifferenceFromRays(*scene, technique);
  INFO("technique " << technique << ", rmse " << difference.rmse);
  // An edge is a fraction of a texel off, which changes some pixels wholly.
  CHECK(difference.rmse <= 6.0);
  scene->GetLight()->SetShadowToNone();
  CHECK(CompareImages(scene->Render(), MakeScene({ "hard", arrange })->Render()).rmse > 12.0);
}

TEST_CASE("Kept shadows: nothing leaks in at the box's border from beyond it")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  // Matter that fills its box and ends at its faces. A ray just below a face leaves the box soon,
  // one a voxel below does not: between them the depth bends once, and texels follow it as well as
  // they can. Light from beyond the box would be worth a hundred.
  auto scene = std::make_unique<IlluminatedScene>(
    SampleField({ { 24, 24, 24 } }, [](const Point& p) { return 140.0 + p[0]; }));
  scene->Mapper->SetSampleDistance(0.5f);
  scene->AddDirectionalLight(-1.0, -0.2, -0.3, vtkVolumeLight::Soft);
  const ImageDifference difference = DifferenceFromRays(*scene, technique);
  INFO("technique " << technique << ", largest " << difference.largest);
  CHECK(difference.largest <= 12.0);
}

TEST_CASE("Kept shadows: the same scene gives the same picture, however it came about")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  auto fresh = MakeScene(SoftCases.front());
  fresh->Mapper->SetShadowTechnique(technique);
  const auto expected = fresh->Render();
  auto scene = MakeScene(SoftCases.front());
  scene->Mapper->SetShadowTechnique(technique);
  scene->GetLight()->SetFocalPoint(1.0, 2.0, 3.0);
  scene->Opacity->AddPoint(90.0, 0.6);
  scene->Render();
  scene->Opacity->RemovePoint(90.0);
  scene->GetLight()->SetFocalPoint(-0.6, -0.7, -0.4);
  CHECK(CompareImages(scene->Render(), expected).largest == 0.0);
  CHECK(CompareImages(scene->Render(), expected).largest == 0.0);
}

TEST_CASE("Kept shadows: where a map tells no soft shadow, a deep map does, and a message says so")
{
  auto scene = MakeScene(SoftCases.front());
  scene->Mapper->SetShadowTechniqueToDeepMap();
  const auto deep = scene->Render();
  CHECK(scene->Mapper->GetMessages().empty());
  scene->Mapper->SetShadowTechniqueToMap();
  CHECK(CompareImages(scene->Render(), deep).largest == 0.0);
  CHECK(scene->Mapper->GetMessages().size() == 1);
}
