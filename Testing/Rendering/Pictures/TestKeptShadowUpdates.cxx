#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

#include <functional>

using namespace penumbra;

namespace
{
vtkVolumeLight* GetLight(IlluminatedScene& scene, int index)
{
  return vtkVolumeLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(index));
}

// Two lights of the scene, one of them a point light, and one that follows the camera.
std::unique_ptr<IlluminatedScene> MakeScene(int technique)
{
  auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 24, 24, 24 } }, 9.0, 4.0), 32, 32);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  scene->AddPointLight(30.0, 30.0, 30.0, vtkVolumeLight::Hard);
  scene->AddDirectionalLight(0.0, 0.0, -1.0, vtkVolumeLight::Soft);
  GetLight(*scene, 2)->SetLightTypeToHeadlight();
  scene->Mapper->SetShadowTechnique(technique);
  scene->Render();
  return scene;
}

struct Edit
{
  std::string name;
  int updates;
  std::function<void(IlluminatedScene&)> make;
};

const std::vector<Edit> Edits = {
  { "nothing", 0, [](IlluminatedScene&) {} },
  { "light turned", 1, [](IlluminatedScene& s) { GetLight(s, 0)->SetFocalPoint(-0.5, 0.3, 1.0); } },
  { "light moved", 1, [](IlluminatedScene& s) { GetLight(s, 1)->SetPosition(30.0, 3.0, 30.0); } },
  { "threshold", 1, [](IlluminatedScene& s) { GetLight(s, 1)->SetOpacityThreshold(0.5); } },
  { "threshold of a soft shadow", 0,
    [](IlluminatedScene& s) { GetLight(s, 0)->SetOpacityThreshold(0.5); } },
  { "camera", 1, [](IlluminatedScene& s) { s.Renderer->GetActiveCamera()->Azimuth(20.0); } },
  { "light's colour", 0, [](IlluminatedScene& s) { GetLight(s, 0)->SetColor(0.5, 0.6, 0.7); } },
  { "intensity", 0, [](IlluminatedScene& s) { GetLight(s, 1)->SetIntensity(0.4); } },
  { "material", 0, [](IlluminatedScene& s) { s.Volume->GetProperty()->SetSpecular(0.6); } },
  { "colour function", 0, [](IlluminatedScene& s) { s.Color->AddRGBPoint(90.0, 0.1, 0.2, 0.9); } },
  { "sample distance of the view", 0,
    [](IlluminatedScene& s)
    {
      s.Mapper->SetShadowSampleDistance(1.0);
      s.Mapper->SetSampleDistance(0.3f);
    } },
  { "opacity", 3, [](IlluminatedScene& s) { s.Opacity->AddPoint(90.0, 0.2); } },
  { "unit distance", 3,
    [](IlluminatedScene& s) { s.Volume->GetProperty()->SetScalarOpacityUnitDistance(2.0); } },
  { "gradient opacity", 3,
    [](IlluminatedScene& s)
    {
      vtkNew<vtkPiecewiseFunction> function;
      function->AddPoint(0.0, 0.1);
      function->AddPoint(50.0, 1.0);
      s.Volume->GetProperty()->SetGradientOpacity(function);
    } },
  { "shadow step", 3, [](IlluminatedScene& s) { s.Mapper->SetShadowSampleDistance(0.7); } },
  { "resolution", 3, [](IlluminatedScene& s) { s.Mapper->SetShadowResolution(0.5); } },
  { "cropping", 3,
    [](IlluminatedScene& s)
    {
      s.Mapper->CroppingOn();
      s.Mapper->SetCroppingRegionPlanes(5.0, 20.0, 0.0, 20.0, 0.0, 20.0);
    } },
  { "clipping", 3,
    [](IlluminatedScene& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(10.0, 0.0, 0.0);
      s.Mapper->AddClippingPlane(plane);
    } },
  { "mask", 3,
    [](IlluminatedScene& s)
    {
      s.Mapper->SetMaskInput(MakeSlab({ { 24, 24, 24 } }, 0, 3.0, 12.0));
      s.Mapper->SetMaskTypeToBinary();
    } },
  { "interpolation", 3,
    [](IlluminatedScene& s) { s.Volume->GetProperty()->SetInterpolationTypeToNearest(); } },
  { "volume", 3,
    [](IlluminatedScene& s) {
      s.Mapper->SetInputData(MakeBall({ { 24, 24, 24 } }, 5.0, 4.0));
    } },
};
}

TEST_CASE("Kept shadows: an edit computes the lights anew that it concerns, and no others")
{
  const int technique = GENERATE(vtkIlluminatedVolumeMapper::Volume,
    vtkIlluminatedVolumeMapper::DeepMap, vtkIlluminatedVolumeMapper::OpacityMap);
  for (const Edit& edit : Edits)
  {
    INFO(edit.name << " by technique " << technique);
    auto scene = MakeScene(technique);
    CHECK(scene->Mapper->GetNumberOfShadowUpdates() == 3);
    edit.make(*scene);
    scene->Render();
    CHECK(scene->Mapper->GetNumberOfShadowUpdates() - 3 == edit.updates);
    scene->Render();
    CHECK(scene->Mapper->GetNumberOfShadowUpdates() - 3 == edit.updates);
  }
}

TEST_CASE("Kept shadows: coarser opacity maps lie in the texture of finer ones that is there")
{
  constexpr int technique = vtkIlluminatedVolumeMapper::OpacityMap;
  auto scene = MakeScene(technique);
  scene->Mapper->SetShadowResolution(2.0);
  const auto fine = scene->Render();
  const std::size_t bytes = scene->Mapper->GetShadowBytes();
  scene->Mapper->SetShadowResolution(0.5);
  const auto coarse = scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() == bytes);
  CHECK(scene->Mapper->GetActualShadowResolution() < 0.6);
  auto fresh = MakeScene(technique);
  fresh->Mapper->SetShadowResolution(0.5);
  // Where the texture is another, coordinates are rounded otherwise.
  CHECK(CompareImages(fresh->Render(), coarse).largest <= 1.0);
  CHECK(CompareImages(fine, coarse).largest > 2.0);
  scene->Mapper->SetShadowResolution(2.0);
  CHECK(CompareImages(scene->Render(), fine).largest == 0.0);
  CHECK(scene->Mapper->GetShadowBytes() == bytes);
  // But not where it would be more than is allowed.
  constexpr std::size_t mebibyte = 1 << 20;
  CHECK(bytes > mebibyte);
  scene->Mapper->SetShadowMemoryLimit(1);
  scene->Mapper->SetShadowResolution(0.5);
  scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() <= mebibyte);
}

TEST_CASE(
  "Kept shadows: less memory makes it coarser, with a message, and none when it is not used")
{
  auto scene =
    std::make_unique<IlluminatedScene>(MakeBall({ { 128, 128, 96 } }, 40.0, 4.0), 16, 16);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  scene->Mapper->SetShadowTechniqueToVolume();
  scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() == 128 * 128 * 96);
  CHECK(scene->Mapper->GetActualShadowResolution() == 1.0);
  CHECK(scene->Mapper->GetMessages().empty());
  scene->Mapper->SetShadowMemoryLimit(1);
  scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() <= 1 << 20);
  CHECK(scene->Mapper->GetActualShadowResolution() < 1.0);
  CHECK(scene->Mapper->GetMessages().size() == 1);
  scene->GetLight()->SetShadowToNone();
  scene->Render();
  CHECK(scene->Mapper->GetShadowBytes() == 0);
  CHECK(scene->Mapper->GetRequirements().Technique == ShadowTechnique::Rays);
}
