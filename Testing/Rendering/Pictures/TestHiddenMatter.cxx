#include "Catch.h"
#include "IlluminatedScene.h"
#include "ImageComparison.h"
#include "SyntheticVolumes.h"

#include <vtkPlane.h>

#include <functional>
#include <memory>

using namespace penumbra;

namespace
{
constexpr double CutHeight = 15.25;

// A floor, and high above it a slab that shadows it.
vtkSmartPointer<vtkImageData> MakeFloor(bool withSlab)
{
  return SampleField({ { 32, 32, 32 } },
    [=](const Point& p)
    {
      const bool inFloor = p[1] >= 4.0 && p[1] <= 9.0;
      const bool inSlab = withSlab && p[1] >= 22.0 && p[1] <= 26.0 && p[0] >= 8.0 && p[0] <= 22.0;
      return inFloor || inSlab ? 220.0 : 0.0;
    });
}

std::unique_ptr<IlluminatedScene> MakeScene(bool withSlab, int shadow)
{
  auto scene = std::make_unique<IlluminatedScene>(MakeFloor(withSlab), 96, 96);
  scene->AddDirectionalLight(-0.1, -1.0, -0.2, shadow);
  return scene;
}

void Clip(IlluminatedScene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, CutHeight, 0.0);
  plane->SetNormal(0.0, -1.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
}

void Crop(IlluminatedScene& scene)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  scene.Mapper->SetCroppingRegionPlanes(0.0, 31.0, 0.0, CutHeight, 0.0, 31.0);
}

// The nine regions below the lower plane of y, the others hidden.
void CropRegions(IlluminatedScene& scene)
{
  scene.Mapper->CroppingOn();
  constexpr int lowRowOfRegions = 0x7;
  scene.Mapper->SetCroppingRegionFlags(
    lowRowOfRegions | lowRowOfRegions << 9 | lowRowOfRegions << 18);
  scene.Mapper->SetCroppingRegionPlanes(10.0, 20.0, CutHeight, 30.0, 10.0, 20.0);
}

void Mask(IlluminatedScene& scene)
{
  scene.Mapper->SetMaskInput(
    SampleField({ { 32, 32, 32 } }, [](const Point& p) { return p[1] < CutHeight ? 1.0 : 0.0; }));
  scene.Mapper->SetMaskTypeToBinary();
}

// Matter so thin that it hardly shadows itself, a little denser towards a cut, and just behind the
// cut opaque matter. The light comes from the thin end; the eye looks along the cut, where rays are
// long enough to see something.
std::unique_ptr<IlluminatedScene> MakeCutBeforeOpaqueMatter()
{
  auto scene = std::make_unique<IlluminatedScene>(SampleField(
    { { 33, 33, 33 } }, [](const Point& p) { return p[2] < 5.5 ? 61.0 + p[2] : 255.0; }));
  scene->Opacity->AddPoint(255.0, 0.95);
  scene->AddDirectionalLight(0.0, 0.0, 1.0, vtkVolumeLight::Soft)->SetShadowBias(0.0);
  const double target[3] = { 16.0, 16.0, 5.0 };
  scene->LookFrom(1.0, 0.1, 0.1, 50.0, target);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 5.2);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene->Mapper->AddClippingPlane(plane);
  return scene;
}
}

TEST_CASE("Hidden matter casts no shadow", "[shadow]")
{
  const int shadow = GENERATE(vtkVolumeLight::Soft, vtkVolumeLight::Hard);
  using Hide = void (*)(IlluminatedScene&);
  const Hide hide = GENERATE(as<Hide>{}, Clip, Crop, CropRegions, Mask);
  const auto floorAlone = MakeScene(false, shadow)->Render();
  const auto shadowed = MakeScene(true, shadow)->Render();
  auto scene = MakeScene(true, shadow);
  hide(*scene);
  const auto hidden = scene->Render();
  CHECK(CompareImages(shadowed, floorAlone).rmse > 5.0);
  // Steps are cut at another place, nothing else.
  CHECK(CompareImages(hidden, floorAlone).rmse < 0.3);
}

TEST_CASE("Hidden matter darkens no sample before its cut where a shadow volume is coarse")
{
  auto scene = MakeCutBeforeOpaqueMatter();
  const auto rays = scene->Render();
  scene->Mapper->SetShadowTechniqueToVolume();
  scene->Mapper->SetShadowNearSteps(0);
  // Texels, and steps towards the light, are 4 apart: what is seen last lies between the texel at 4
  // and the hidden one at 8, whose first step would have its middle in opaque matter.
  scene->Mapper->SetShadowResolution(0.25);
  const ImageDifference difference = CompareImages(scene->Render(), rays);
  INFO("rmse " << difference.rmse << ", largest " << difference.largest);
  CHECK(scene->Mapper->GetActualShadowResolution() == 0.25);
  // Texels as coarse as these tell the thin matter's depth to 2 % of the light. A dark rim is worth
  // five times as much.
  CHECK(difference.largest <= 0.02 * 255.0);
}
