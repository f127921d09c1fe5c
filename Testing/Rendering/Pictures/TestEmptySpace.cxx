#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <functional>
#include <memory>

using namespace penumbra;

namespace
{
using Change = std::function<void(IlluminatedScene&)>;

// A ball in the corner of a volume that is empty elsewhere.
std::unique_ptr<IlluminatedScene> MakeScene()
{
  auto image = SampleField({ { 36, 30, 33 } },
    [](const Point& p)
    {
      const double depth = 9.0 - Distance(p, Point{ 13.0, 14.0, 19.0 });
      return 255.0 * std::clamp(depth / 4.0 + 0.5, 0.0, 1.0);
    });
  auto scene = std::make_unique<IlluminatedScene>(image);
  scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
  return scene;
}

// Rounding where a ray is cut moves a sample by less than 1e-5 of a voxel.
void CheckSame(IlluminatedScene& scene)
{
  const auto skipped = scene.Render();
  CHECK(scene.Mapper->GetRequirements().EmptySpaceSkipping);
  CHECK(scene.Mapper->GetNumberOfOccupiedBricks() > 0);
  CHECK(scene.Mapper->GetNumberOfOccupiedBricks() < scene.Mapper->GetNumberOfBricks() / 2);
  scene.Mapper->SkipEmptySpaceOff();
  const auto all = scene.Render();
  CHECK_FALSE(scene.Mapper->GetRequirements().EmptySpaceSkipping);
  CHECK(scene.Mapper->GetNumberOfBricks() == 0);
  CHECK(CompareImages(skipped, all).largest <= 1.0);
  // What is empty is known again, and so may be out of date by the next time.
  scene.Mapper->SkipEmptySpaceOn();
  scene.Render();
}

void Clip(IlluminatedScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, -0.3, 0.2);
  plane->SetOrigin(13.0, 14.0, 19.0);
  scene.Mapper->AddClippingPlane(plane);
}

void Crop(IlluminatedScene& scene)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionFlagsToFence();
  scene.Mapper->SetCroppingRegionPlanes(8.3, 14.6, 9.1, 17.7, 16.2, 21.4);
}

void Mask(IlluminatedScene& scene)
{
  scene.Mapper->SetMaskInput(
    SampleField({ { 36, 30, 33 } }, [](const Point& p) { return p[0] + p[1] > 27.0 ? 1.0 : 0.0; }));
  scene.Mapper->SetMaskTypeToBinary();
}

void MakeSteep(IlluminatedScene& scene)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(120.0, 0.0);
  scene.Opacity->AddPoint(121.0, 0.7);
  scene.Opacity->AddPoint(140.0, 0.7);
  scene.Opacity->AddPoint(141.0, 0.0);
}

void OpacifyGradients(IlluminatedScene& scene)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(20.0, 0.0);
  opacity->AddPoint(60.0, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(opacity);
}
}

TEST_CASE("Empty space: the picture is the same without it", "[emptySpace]")
{
  const auto change = GENERATE(values<Change>({ [](IlluminatedScene&) {}, Clip, Crop, Mask,
    MakeSteep, OpacifyGradients, [](IlluminatedScene& scene) { scene.Shade(false); },
    [](IlluminatedScene& scene)
    {
      MakeSteep(scene);
      scene.Shade(false);
    },
    [](IlluminatedScene& scene)
    {
      MakeSteep(scene);
      scene.Mapper->SetSampleDistance(2.7f);
    },
    [](IlluminatedScene& scene) { scene.AddPointLight(14.0, 12.0, 29.0, vtkVolumeLight::Hard); },
    [](IlluminatedScene& scene) { scene.Mapper->SetSampleDistance(2.7f); },
    [](IlluminatedScene& scene) { scene.Volume->SetScale(1.0, -2.0, 0.7); } }));
  auto scene = MakeScene();
  change(*scene);
  CheckSame(*scene);
}

TEST_CASE("Empty space: it follows what makes matter visible", "[emptySpace]")
{
  auto scene = MakeScene();
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(250.0, 0.0);
  scene->Opacity->AddPoint(255.0, 0.5);
  scene->Render();
  const int few = scene->Mapper->GetNumberOfOccupiedBricks();
  for (const Change& change :
    { Change(Mask),
      Change([](IlluminatedScene& changed) { changed.Opacity->AddSegment(60.0, 0.0, 100.0, 0.2); }),
      Change(Crop),
      Change([](IlluminatedScene& changed) { changed.Mapper->SetMaskInput(nullptr); }),
      Change(OpacifyGradients) })
  {
    change(*scene);
    CheckSame(*scene);
  }
  CHECK(scene->Mapper->GetNumberOfOccupiedBricks() > few);
}

TEST_CASE("Empty space: it is left out by itself where hardly any is empty", "[emptySpace]")
{
  auto scene = MakeScene();
  scene->Opacity->AddPoint(0.0, 1e-9);
  scene->Render();
  CHECK_FALSE(scene->Mapper->GetRequirements().EmptySpaceSkipping);
  CHECK(scene->Mapper->GetNumberOfOccupiedBricks() == scene->Mapper->GetNumberOfBricks());
}
