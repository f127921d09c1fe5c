#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
Fault CroppedHalfAVoxelOff()
{
  return { "cropped half a voxel off", [](IlluminatedScene& scene) {
            scene.Mapper->SetCroppingRegionPlanes(2.8, 41.2, 6.0, 30.7, 9.3, 27.9);
          } };
}
}

// Cropping between voxels, lit into the cut.
TEST_CASE("Picture: cropped shells", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeShells({ { 48, 48, 48 } }, 11.0));
    scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
    scene->Mapper->CroppingOn();
    scene->Mapper->SetCroppingRegionFlagsToSubVolume();
    scene->Mapper->SetCroppingRegionPlanes(2.3, 40.7, 5.5, 30.2, 8.8, 27.4);
    return scene;
  };
  CheckPicture("CroppedShells", make, { CroppedHalfAVoxelOff(), NoShadow(), HalfTheDensity() });
}
