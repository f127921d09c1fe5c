#include "Catch.h"
#include "KeptShadowDifference.h"
#include "SyntheticVolumes.h"

#include <vtkPlane.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace penumbra;

namespace
{
using Mapper = vtkIlluminatedVolumeMapper;

double InBall(const Point& p, const Point& centre, double radius)
{
  return 255.0 * std::clamp((radius - Distance(p, centre)) / 4.0 + 0.5, 0.0, 1.0);
}

// Two balls in a corner of an empty volume, one in the other's shadow.
std::unique_ptr<IlluminatedScene> MakeCorner()
{
  auto scene = std::make_unique<IlluminatedScene>(SampleField({ { 56, 52, 48 } },
    [](const Point& p) {
      return std::max(InBall(p, { 44, 40, 36 }, 6.0), InBall(p, { 37, 28, 38 }, 6.0));
    }));
  scene->Mapper->SetSampleDistance(0.5f);
  scene->Mapper->SetShadowNearSteps(1);
  return scene;
}
}

TEST_CASE("Kept shadows: a little matter in a large volume has the rays' shadows")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  const bool near = GENERATE(false, true);
  auto scene = MakeCorner();
  if (near)
  {
    scene->AddPointLight(50.0, 50.0, 34.0, vtkVolumeLight::Soft);
  }
  else
  {
    scene->AddDirectionalLight(-0.5, -0.9, 0.1, vtkVolumeLight::Soft);
  }
  const ImageDifference difference = DifferenceFromRays(*scene, technique);
  INFO("technique " << technique << ", rmse " << difference.rmse << ", largest "
                    << difference.largest);
  // What texels and their eight bits are off; a shadow missed is worth a hundred.
  CHECK(difference.largest <= 4.0);
  const auto leaping = scene->Render();
  scene->Mapper->SkipEmptySpaceOff();
  CHECK(CompareImages(scene->Render(), leaping).largest <= 1.0);
}

TEST_CASE("Kept shadows: nothing leaks in at a cut along the light")
{
  const int technique = GENERATE(Mapper::Volume, Mapper::DeepMap, Mapper::OpacityMap);
  auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 40, 40, 40 } }, 16.0, 12.0));
  scene->Mapper->SetSampleDistance(0.5f);
  scene->AddDirectionalLight(-0.3, -1.0, 0.0, vtkVolumeLight::Soft);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 20.3);
  plane->SetNormal(0.0, 0.0, -1.0);
  scene->Mapper->AddClippingPlane(plane);
  const ImageDifference difference = DifferenceFromRays(*scene, technique);
  INFO("technique " << technique << ", rmse " << difference.rmse << ", largest "
                    << difference.largest);
  // As above; light from beside the cut is worth eleven in the first half of a voxel.
  CHECK(difference.largest <= 4.0);
}

TEST_CASE("Kept shadows: a deep map of more plates than it has nodes is as near as these allow")
{
  // Nine thin plates in a light's way, each dimming it a little.
  auto scene = std::make_unique<IlluminatedScene>(SampleField({ { 24, 96, 24 } },
    [](const Point& p)
    { return 40.0 + 60.0 * std::pow(std::sin(0.30 * p[1] + 0.02 * p[0]), 6.0); }));
  scene->Mapper->SetSampleDistance(0.5f);
  scene->Mapper->SetShadowNearSteps(0);
  scene->AddDirectionalLight(0.0, -1.0, 0.1, vtkVolumeLight::Soft);
  const ImageDifference difference = DifferenceFromRays(*scene, Mapper::DeepMap);
  INFO("rmse " << difference.rmse << ", largest " << difference.largest);
  // 0.88; by the first tolerance that is enough, up to three times the least, it is 1.23.
  CHECK(difference.rmse <= 1.0);
}
