#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "RenderToImage.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkPointData.h>

#include <memory>

using namespace penumbra;

namespace
{
std::unique_ptr<IlluminatedScene> MakeScene(vtkImageData* image)
{
  auto scene = std::make_unique<IlluminatedScene>(image, 64, 64);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  return scene;
}

// The window's resources go while another mapper draws its volume.
void LoseResources(IlluminatedScene& scene)
{
  vtkNew<vtkIlluminatedVolumeMapper> other;
  other->SetInputConnection(scene.Mapper->GetInputConnection(0, 0));
  scene.Volume->SetMapper(other);
  scene.Render();
  scene.Window->Finalize();
  scene.Render();
  scene.Volume->SetMapper(scene.Mapper);
}
}

TEST_CASE("Stale: resources released behind the mapper's back come back", "[stale]")
{
  const double imageSampleDistance = GENERATE(1.0, 2.0);
  auto scene = MakeScene(MakeBall({ { 24, 24, 24 } }, 10.0, 4.0));
  scene->Mapper->SetImageSampleDistance(imageSampleDistance);
  scene->Mapper->SetMaskInput(
    SampleField({ { 24, 24, 24 } }, [](const Point& p) { return p[0] < 12.0 ? 1.0 : 0.0; }));
  scene->Mapper->SetMaskTypeToBinary();
  const auto before = scene->Render();
  LoseResources(*scene);
  CHECK(CompareImages(scene->Render(), before).largest == 0.0);
}

TEST_CASE("Stale: one array as two volumes of different dimensions", "[stale]")
{
  auto deep = MakeRamp({ { 12, 16, 24 } }, 1);
  vtkNew<vtkImageData> wide;
  wide->SetDimensions(24, 16, 12);
  wide->GetPointData()->SetScalars(deep->GetPointData()->GetScalars());
  const auto expected = MakeScene(wide)->Render();
  auto scene = MakeScene(wide);
  scene->Mapper->SetInputData(deep);
  scene->Render();
  scene->Mapper->SetInputData(wide);
  CHECK(CompareImages(scene->Render(), expected).largest == 0.0);
}

TEST_CASE(
  "Stale: a volume that the graphics card cannot hold leaves the last one in order", "[stale]")
{
  auto ball = MakeBall({ { 24, 24, 24 } }, 10.0, 4.0);
  auto scene = MakeScene(ball);
  scene->Mapper->GlobalWarningDisplayOff();
  const auto before = scene->Render();
  VolumeGrid tooLong;
  tooLong.dimensions = { 20000, 2, 2 };
  tooLong.scalarType = VTK_FLOAT;
  scene->Mapper->SetInputData(MakeRamp(tooLong, 0));
  scene->Render();
  scene->Mapper->SetInputData(ball);
  CHECK(CompareImages(scene->Render(), before).largest == 0.0);
}

TEST_CASE("Stale: another window's end does not take this one's volume", "[stale]")
{
  auto scene = MakeScene(MakeBall({ { 24, 24, 24 } }, 10.0, 4.0));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(scene->Renderer->GetBackground());
  renderer->AddVolume(scene->Volume);
  renderer->SetActiveCamera(scene->Renderer->GetActiveCamera());
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(64, 64);
  other->AddRenderer(renderer);
  RenderToImage(other);
  const auto before = scene->Render();
  other->Finalize();
  CHECK(CompareImages(scene->Render(), before).largest == 0.0);
}

TEST_CASE("Stale: what a scene needs is known where nothing of it is visible", "[stale]")
{
  auto scene = MakeScene(MakeBall({ { 24, 24, 24 } }, 10.0, 4.0));
  scene->Mapper->CroppingOn();
  scene->Mapper->SetCroppingRegionFlagsToSubVolume();
  scene->Mapper->SetCroppingRegionPlanes(100.0, 200.0, 0.0, 10.0, 0.0, 10.0);
  const auto cropped = scene->Render();
  CHECK(scene->Mapper->GetRequirements().GetNumberOfLights(ShadowKind::Soft) == 1);
  CHECK(scene->Mapper->GetRequirements().Cropping == CroppingKind::Box);
  scene->Volume->VisibilityOff();
  CHECK(CompareImages(cropped, scene->Render()).largest == 0.0);
}

TEST_CASE("Stale: what the stock ray caster draws survives the end of its window", "[stale]")
{
  auto scene = MakeScene(MakeBall({ { 24, 24, 24 } }, 10.0, 4.0));
  scene->Mapper->GlobalWarningDisplayOff();
  scene->Render();
  scene->Window->RemoveRenderer(scene->Renderer);
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(64, 64);
  other->AddRenderer(scene->Renderer);
  scene->Mapper->SetBlendModeToMaximumIntensity();
  const auto before = RenderToImage(other);
  other->Finalize();
  CHECK(CompareImages(RenderToImage(other), before).largest == 0.0);
  scene->Volume->VisibilityOff();
  CHECK(CompareImages(RenderToImage(other), before).rmse > 5.0);
}
