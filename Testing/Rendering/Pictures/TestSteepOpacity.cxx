#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double LargestOpacity = 0.3;
constexpr double PeakWidth = 3.0;
constexpr double ValuesPerLength = 255.0 / 31.0;

// Scalars rise by 8.2 a voxel; only values of a range of 3 have matter.
std::unique_ptr<IlluminatedScene> MakePeakScene(double step)
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 32 };
  grid.spacing = { 100.0, 100.0, 1.0 };
  grid.scalarType = VTK_FLOAT;
  auto scene = std::make_unique<IlluminatedScene>(MakeRamp(grid, 2), 32, 32);
  scene->Shade(false);
  scene->Renderer->SetBackground(0.0, 0.0, 0.0);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(100.0, 0.0);
  scene->Opacity->AddPoint(100.0 + 0.5 * PeakWidth, LargestOpacity);
  scene->Opacity->AddPoint(100.0 + PeakWidth, 0.0);
  // Red before the peak, green within it, blue behind.
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(95.0, 1.0, 0.0, 0.0);
  scene->Color->AddRGBPoint(100.0, 0.0, 1.0, 0.0);
  scene->Color->AddRGBPoint(100.0 + PeakWidth, 0.0, 1.0, 0.0);
  scene->Color->AddRGBPoint(108.0, 0.0, 0.0, 1.0);
  scene->Volume->GetProperty()->SetScalarOpacityUnitDistance(0.05);
  scene->Mapper->SetSampleDistance(static_cast<float>(step));
  const double center[3] = { 100.0, 100.0, 15.0 };
  scene->LookFrom(0.0, 0.0, 1.0, 1000.0, center);
  scene->Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene->Renderer->GetActiveCamera()->SetParallelScale(50.0);
  return scene;
}

// The integral of -ln(1 - a) over a triangle from 0 to the largest opacity A and back is
// w (A + (1 - A) ln(1 - A)) / A, over scalars; lengths are scalars over the slope.
double ExpectedAlpha()
{
  const double a = LargestOpacity;
  const double overScalars = PeakWidth * (a + (1.0 - a) * std::log(1.0 - a)) / a;
  return 1.0 - std::exp(-overScalars / ValuesPerLength / 0.05);
}

double LevelOf(IlluminatedScene& scene, int channel)
{
  return scene.Render()->GetScalarComponentAsDouble(16, 16, 0, channel);
}
}

TEST_CASE("A peak that a step passes over counts as a whole, whatever the step")
{
  const double step = GENERATE(0.2, 0.5, 1.0, 2.7);
  const auto scene = MakePeakScene(step);
  CHECK(LevelOf(*scene, 1) == Approx(255.0 * ExpectedAlpha()).margin(1.0));
  CHECK(scene->Mapper->GetRequirements().PreIntegrated);
  // Its colour is its own, and not that of the step's middle.
  CHECK(LevelOf(*scene, 0) <= 1.0);
  CHECK(LevelOf(*scene, 2) <= 1.0);
}

// Such steps are looked up among their points, and their integrals in the table beside these.
TEST_CASE("A peak with sheer sides counts as a whole, whatever the step")
{
  const double step = GENERATE(0.5, 2.7);
  const auto scene = MakePeakScene(step);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AllowDuplicateScalarsOn();
  scene->Opacity->AddPoint(100.0, 0.0);
  scene->Opacity->AddPoint(100.0, 0.1);
  scene->Opacity->AddPoint(100.0 + PeakWidth, 0.1);
  scene->Opacity->AddPoint(100.0 + PeakWidth, 0.0);
  const double transparency = std::pow(1.0 - 0.1, PeakWidth / ValuesPerLength / 0.05);
  CHECK(LevelOf(*scene, 1) == Approx(255.0 * (1.0 - transparency)).margin(1.0));
  CHECK(scene->Mapper->GetRequirements().PreIntegrated);
}

TEST_CASE("A clipping plane within a peak keeps the part before it")
{
  const auto scene = MakePeakScene(2.7);
  vtkNew<vtkPlane> plane;
  // Keeps what is behind the middle of the peak: half of it, as seen along -z.
  plane->SetOrigin(0.0, 0.0, (100.0 + 0.5 * PeakWidth) / ValuesPerLength);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene->Mapper->AddClippingPlane(plane);
  const double half = 1.0 - std::sqrt(1.0 - ExpectedAlpha());
  CHECK(LevelOf(*scene, 1) == Approx(255.0 * half).margin(1.0));
}

TEST_CASE("Soft shadows pass over a peak as view rays do")
{
  const auto scene = MakePeakScene(0.5);
  // The peak shadows itself: half of it lies before its middle.
  scene->Shade(true);
  vtkVolumeProperty* property = scene->Volume->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene->AddDirectionalLight(0.0, 0.0, -1.0, vtkVolumeLight::Soft)->SetShadowBias(0.0);
  scene->Mapper->SetShadowSampleDistance(2.7);
  const double coarse = LevelOf(*scene, 0);
  CHECK(scene->Mapper->GetRequirements().PreIntegrated);
  scene->Mapper->SetShadowSampleDistance(0.1);
  CHECK(coarse == Approx(LevelOf(*scene, 0)).margin(2.0));
}
