#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>

#include <memory>

using namespace penumbra;

namespace
{
std::unique_ptr<IlluminatedScene> MakeScene()
{
  auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 32, 32, 32 } }, 12.0, 6.0));
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  return scene;
}

double GetMean(vtkImageData* picture)
{
  const auto* values = static_cast<unsigned char*>(picture->GetScalarPointer());
  const vtkIdType count = 3 * picture->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    sum += values[i];
  }
  return sum / static_cast<double>(count);
}
}

TEST_CASE("Interaction: an update rate that cannot be met costs rays, not brightness")
{
  auto scene = MakeScene();
  const auto still = scene->Render();
  CHECK(scene->Mapper->GetActualImageSampleDistance() == 1.0);
  scene->Window->SetDesiredUpdateRate(1e6);
  scene->Render();
  const auto moving = scene->Render();
  CHECK(scene->Mapper->GetActualImageSampleDistance() == 8.0);
  // Coarse pixels at the ball's edge weigh more or less than they should, by a grey level in all.
  CHECK(GetMean(moving) == Approx(GetMean(still)).margin(1.0));
  CHECK(CompareImages(moving, still).rmse > 1.0);
  scene->Window->SetDesiredUpdateRate(0.0001);
  CHECK(CompareImages(scene->Render(), still).largest == 0.0);
}

TEST_CASE("Interaction: what need not adjust itself has all its rays")
{
  auto scene = MakeScene();
  scene->Mapper->AutoAdjustSampleDistancesOff();
  const auto still = scene->Render();
  scene->Window->SetDesiredUpdateRate(1e6);
  scene->Render();
  CHECK(CompareImages(scene->Render(), still).largest == 0.0);
}

TEST_CASE("Interaction: while a light moves its shadows are kept coarser, and no others anew")
{
  const int technique =
    GENERATE(vtkIlluminatedVolumeMapper::Volume, vtkIlluminatedVolumeMapper::OpacityMap);
  auto scene = MakeScene();
  scene->Mapper->SetShadowTechnique(technique);
  scene->Render();
  const double full = scene->Mapper->GetActualShadowResolution();
  scene->Window->SetDesiredUpdateRate(1e6);
  scene->Renderer->GetActiveCamera()->Azimuth(10.0);
  scene->Render();
  CHECK(scene->Mapper->GetActualShadowResolution() == full);
  CHECK(scene->Mapper->GetNumberOfShadowUpdates() == 1);
  scene->GetLight()->SetFocalPoint(-0.5, -0.8, -0.3);
  scene->Render();
  scene->Renderer->GetActiveCamera()->Azimuth(-10.0);
  scene->Render();
  CHECK(scene->Mapper->GetActualShadowResolution() == Approx(0.5 * full).epsilon(0.1));
  CHECK(scene->Mapper->GetNumberOfShadowUpdates() == 2);
  CHECK(scene->Mapper->GetMessages().empty());
  scene->Window->SetDesiredUpdateRate(0.0001);
  const auto still = scene->Render();
  CHECK(scene->Mapper->GetActualShadowResolution() == full);
  auto fresh = MakeScene();
  fresh->Mapper->SetShadowTechnique(technique);
  fresh->GetLight()->SetFocalPoint(-0.5, -0.8, -0.3);
  CHECK(CompareImages(fresh->Render(), still).largest == 0.0);
}
