#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <memory>

using namespace penumbra;

namespace
{
std::unique_ptr<IlluminatedScene> MakeScene()
{
  auto scene = std::make_unique<IlluminatedScene>(MakeShells({ { 24, 24, 24 } }, 9.0), 96, 96);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  // The fallback says so through vtkWarningMacro, which is not what is tested.
  scene->Mapper->GlobalWarningDisplayOff();
  return scene;
}

vtkSmartPointer<vtkImageData> RenderStock(IlluminatedScene& scene)
{
  vtkNew<vtkGPUVolumeRayCastMapper> stock;
  stock->SetInputConnection(scene.Mapper->GetInputConnection(0, 0));
  stock->SetBlendMode(scene.Mapper->GetBlendMode());
  stock->AutoAdjustSampleDistancesOff();
  stock->SetSampleDistance(scene.Mapper->GetSampleDistance());
  scene.Volume->SetMapper(stock);
  auto picture = scene.Render();
  scene.Volume->SetMapper(scene.Mapper);
  return picture;
}
}

TEST_CASE("Fallback: a maximum intensity projection is the stock mapper's", "[fallback]")
{
  auto scene = MakeScene();
  const auto lit = scene->Render();
  CHECK(scene->Mapper->GetMessages().empty());
  scene->Mapper->SetBlendModeToMaximumIntensity();
  scene->Mapper->SetSampleDistance(0.5f);
  const auto projection = scene->Render();
  REQUIRE(scene->Mapper->GetMessages().size() == 1);
  CHECK(scene->Mapper->GetMessages()[0].find("blend mode") != std::string::npos);
  CHECK(CompareImages(projection, RenderStock(*scene)).largest == 0.0);
  CHECK(CompareImages(projection, lit).rmse > 5.0);
  scene->Mapper->SetBlendModeToComposite();
  CHECK(CompareImages(scene->Render(), lit).largest == 0.0);
  CHECK(scene->Mapper->GetMessages().empty());
}

TEST_CASE("Fallback: more lights than the stock mapper holds do no harm", "[fallback]")
{
  auto scene = MakeScene();
  for (int i = 0; i < 40; ++i)
  {
    scene->AddDirectionalLight(-0.6, 0.1 * i, -0.4, vtkVolumeLight::None);
  }
  scene->Mapper->SetBlendModeToMaximumIntensity();
  auto picture = scene->Render();
  scene->Volume->VisibilityOff();
  CHECK(CompareImages(picture, scene->Render()).rmse > 5.0);
  CHECK(scene->GetLight()->GetSwitch() == 1);
}

TEST_CASE("Fallback: two components are not blank", "[fallback]")
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(16, 16, 16);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 2);
  auto* scalars = static_cast<unsigned char*>(image->GetScalarPointer());
  std::generate_n(scalars, 2 * 16 * 16 * 16,
    [voxel = 0]() mutable { return static_cast<unsigned char>(voxel++ / 32); });
  IlluminatedScene scene(image, 64, 64);
  scene.Mapper->GlobalWarningDisplayOff();
  scene.AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  scene.Volume->GetProperty()->IndependentComponentsOn();
  scene.Volume->GetProperty()->SetScalarOpacity(1, scene.Opacity);
  scene.Volume->GetProperty()->SetColor(1, scene.Color);
  scene.Volume->GetProperty()->ShadeOn(1);
  const auto picture = scene.Render();
  scene.Volume->VisibilityOff();
  CHECK(CompareImages(picture, scene.Render()).rmse > 5.0);
}
