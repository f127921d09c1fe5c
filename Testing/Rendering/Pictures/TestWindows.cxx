#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "RenderToImage.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkImageData.h>

#include <algorithm>
#include <memory>

using namespace penumbra;

namespace
{
std::unique_ptr<IlluminatedScene> MakeScene(int width = 96, int height = 96)
{
  auto scene =
    std::make_unique<IlluminatedScene>(MakeShells({ { 24, 24, 24 } }, 9.0), width, height);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  return scene;
}

double GetLargestDifference(vtkImageData* a, vtkImageData* b)
{
  return CompareImages(a, b).largest;
}

vtkSmartPointer<vtkImageData> GetPart(vtkImageData* picture, int firstColumn, int columns)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  const int rows = picture->GetDimensions()[1];
  part->SetDimensions(columns, rows, 1);
  part->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int row = 0; row < rows; ++row)
  {
    const auto* from = static_cast<unsigned char*>(picture->GetScalarPointer(firstColumn, row, 0));
    std::copy_n(from, 3 * columns, static_cast<unsigned char*>(part->GetScalarPointer(0, row, 0)));
  }
  return part;
}
}

TEST_CASE("Window: a resized window shows what a fresh one of its size does", "[window]")
{
  auto scene = MakeScene();
  scene->Render();
  scene->Window->SetSize(70, 120);
  CHECK(GetLargestDifference(scene->Render(), MakeScene(70, 120)->Render()) == 0.0);
}

TEST_CASE("Window: the same scene gives the same bytes", "[window]")
{
  auto scene = MakeScene();
  const auto first = scene->Render();
  CHECK(GetLargestDifference(scene->Render(), first) == 0.0);
  CHECK(GetLargestDifference(MakeScene()->Render(), first) == 0.0);
}

// One renderer's camera, lights and volume in both halves of a window.
TEST_CASE("Window: two viewports show what two windows do", "[window]")
{
  auto scene = MakeScene();
  const auto alone = scene->Render();
  vtkNew<vtkRenderer> right;
  right->SetBackground(scene->Renderer->GetBackground());
  right->AutomaticLightCreationOff();
  right->AddLight(scene->GetLight());
  right->SetActiveCamera(scene->Renderer->GetActiveCamera());
  right->AddVolume(scene->Volume);
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene->Window->AddRenderer(right);
  scene->Window->SetSize(192, 96);
  const double imageSampleDistance = GENERATE(1.0, 2.0);
  scene->Mapper->SetImageSampleDistance(imageSampleDistance);
  const auto both = scene->Render();
  const auto left = GetPart(both, 0, 96);
  CHECK(GetLargestDifference(left, GetPart(both, 96, 96)) == 0.0);
  // With fewer rays only the blur of stretching is in between.
  CHECK(CompareImages(left, alone).rmse <= (imageSampleDistance == 1.0 ? 0.0 : 8.0));
}

TEST_CASE("Window: the mapper moves to another window and back", "[window]")
{
  auto scene = MakeScene();
  const auto before = scene->Render();
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(96, 96);
  scene->Window->RemoveRenderer(scene->Renderer);
  other->AddRenderer(scene->Renderer);
  CHECK(GetLargestDifference(RenderToImage(other), before) == 0.0);
  other->RemoveRenderer(scene->Renderer);
  scene->Window->AddRenderer(scene->Renderer);
  CHECK(GetLargestDifference(scene->Render(), before) == 0.0);
}

TEST_CASE("Window: released graphics resources come back", "[window]")
{
  auto scene = MakeScene();
  const auto before = scene->Render();
  scene->Mapper->ReleaseGraphicsResources(scene->Window);
  CHECK(GetLargestDifference(scene->Render(), before) == 0.0);
  scene->Window->Finalize();
  CHECK(GetLargestDifference(scene->Render(), before) == 0.0);
}

TEST_CASE("Window: changed voxels and dimensions are drawn", "[window]")
{
  auto image = MakeShells({ { 24, 24, 24 } }, 9.0);
  IlluminatedScene scene(image, 96, 96);
  scene.AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  const auto shells = scene.Render();
  image->DeepCopy(MakeBall({ { 24, 24, 24 } }, 10.0, 4.0));
  const auto ball = scene.Render();
  CHECK(GetLargestDifference(shells, ball) > 50.0);
  image->DeepCopy(MakeShells({ { 24, 24, 24 } }, 9.0));
  CHECK(GetLargestDifference(scene.Render(), shells) == 0.0);
  // Twice as fine, the same extent in space.
  const double fine = 23.0 / 46.0;
  image->DeepCopy(MakeBall({ { 47, 47, 47 }, { fine, fine, fine } }, 10.0, 4.0));
  CHECK(CompareImages(scene.Render(), ball).ssim > 0.98);
}

// The pictures do not overlap, so each pixel shows one volume or none.
TEST_CASE("Window: two mappers in one renderer draw both volumes", "[window]")
{
  auto scene = MakeScene();
  const auto first = scene->Render();
  vtkNew<vtkIlluminatedVolumeMapper> mapper;
  mapper->SetInputData(MakeBall({ { 16, 16, 16 } }, 7.0, 3.0));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(scene->Volume->GetProperty());
  volume->SetPosition(24.0, 22.0, -10.0);
  scene->Renderer->AddVolume(volume);
  const auto both = scene->Render();
  scene->Renderer->RemoveVolume(scene->Volume);
  const auto second = scene->Render();

  const auto* background = static_cast<unsigned char*>(first->GetScalarPointer());
  int shown[2] = { 0, 0 };
  for (int row = 0; row < 96; ++row)
  {
    for (int column = 0; column < 96; ++column)
    {
      const auto* a = static_cast<unsigned char*>(first->GetScalarPointer(column, row, 0));
      const auto* b = static_cast<unsigned char*>(second->GetScalarPointer(column, row, 0));
      const auto* drawn = static_cast<unsigned char*>(both->GetScalarPointer(column, row, 0));
      const bool inFirst = !std::equal(a, a + 3, background);
      const bool inSecond = !std::equal(b, b + 3, background);
      shown[0] += inFirst;
      shown[1] += inSecond;
      if (!inFirst || !inSecond)
      {
        CHECK(std::equal(drawn, drawn + 3, inFirst ? a : b));
      }
    }
  }
  CHECK(shown[0] > 1000);
  CHECK(shown[1] > 200);
}
