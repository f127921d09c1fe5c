#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkPlane.h>

#include <memory>

using namespace penumbra;

namespace
{
constexpr double Edge = 8.0; // of the box, in voxels
constexpr double Rays = Edge * Edge;

// A slab of even, thin matter, seen along z and lit from where it is seen. One ray a voxel, one
// step a voxel.
std::unique_ptr<IlluminatedScene> MakeSlab()
{
  auto scene = std::make_unique<IlluminatedScene>(
    SampleField({ { 9, 9, 9 } }, [](const Point& p) { return 100.0 + 10.0 * (Edge - p[2]); }), 32,
    32);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.05);
  scene->AddDirectionalLight(0.0, 0.0, -1.0, vtkVolumeLight::Soft)->SetShadowBias(0.0);
  scene->Mapper->SetSampleDistance(1.0f);
  scene->Mapper->SetShadowSampleDistance(1.0);
  scene->Mapper->RayCountingOn();
  const double center[3] = { 4.0, 4.0, 4.0 };
  scene->LookFrom(0.0, 0.0, 1.0, 40.0, center);
  scene->Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene->Renderer->GetActiveCamera()->SetParallelScale(16.0);
  return scene;
}
}

TEST_CASE("Ray counts: a slab takes one sample and one more shadow step a voxel")
{
  auto scene = MakeSlab();
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * Edge);
  CHECK(scene->Mapper->GetNumberOfShadedSamples() == Rays * Edge);
  // From the middle of the first voxel half a step, from that of the second one and a half.
  CHECK(scene->Mapper->GetNumberOfShadowSteps() == Rays * (1 + 2 + 3 + 4 + 5 + 6 + 7 + 8));
}

TEST_CASE("Ray counts: what is cut away takes no samples")
{
  auto scene = MakeSlab();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 5.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene->Mapper->AddClippingPlane(plane);
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * 5);
  CHECK(scene->Mapper->GetNumberOfShadowSteps() == Rays * (1 + 2 + 3 + 4 + 5));
}

TEST_CASE("Ray counts: opaque matter ends rays")
{
  auto scene = MakeSlab();
  scene->Opacity->AddPoint(0.0, 0.9999);
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays);
  CHECK(scene->Mapper->GetNumberOfShadowSteps() == Rays);
}

TEST_CASE("Ray counts: a ray ends where what is behind adds a grey level, or a quarter of it")
{
  auto scene = MakeSlab();
  scene->Opacity->AddPoint(0.0, 0.7);
  scene->Render();
  // 0.3^5 < 1 / 255 < 0.3^4
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * 5);
  scene->Mapper->SetSampleDistance(0.5f);
  scene->Render();
  // 0.3^6 < 1 / 1000 < 0.3^5.5
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * 12);
}

TEST_CASE("Ray counts: matter without light is sampled, and shaded nowhere")
{
  auto scene = MakeSlab();
  scene->Shade(false);
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * Edge);
  CHECK(scene->Mapper->GetNumberOfShadedSamples() == 0.0);
  CHECK(scene->Mapper->GetNumberOfShadowSteps() == 0.0);
}

TEST_CASE("Ray counts: a picture of several draws counts as one")
{
  auto scene = MakeSlab();
  constexpr int stepsPerVoxel = 512;
  scene->Mapper->SetSampleDistance(1.0f / stepsPerVoxel);
  scene->Mapper->SetShadowSampleDistance(0.125);
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfDraws() > 1);
  CHECK(scene->Mapper->GetNumberOfSamples() == Rays * Edge * stepsPerVoxel);
  // 64 shadow steps through the slab, and as many samples within each: one step for those within
  // the first, two within the second.
  CHECK(scene->Mapper->GetNumberOfShadowSteps() == Rays * (stepsPerVoxel / 8) * 64 * 65 / 2);
}

TEST_CASE("Ray counts: counting changes no picture, and nothing is counted unless it is asked for")
{
  auto scene = MakeSlab();
  const auto counted = scene->Render();
  const int builds = scene->Mapper->GetNumberOfShaderBuilds();
  scene->Mapper->RayCountingOff();
  CHECK(CompareImages(scene->Render(), counted).largest == 0.0);
  CHECK(scene->Mapper->GetNumberOfSamples() == 0.0);
  CHECK(scene->Mapper->GetNumberOfShaderBuilds() == builds + 1);
  scene->Render();
  CHECK(scene->Mapper->GetNumberOfShaderBuilds() == builds + 1);
  CHECK(scene->Mapper->GetFragmentShaderSource().find("counted") == std::string::npos);
}
