#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

#include <vtkPlane.h>

using namespace penumbra;

// Shells dim each other, seen through a cut.
TEST_CASE("Picture: soft shadow shells", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeShells({ { 48, 48, 48 } }, 11.0));
    scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(23.5, 23.5, 23.5);
    plane->SetNormal(-0.6, 0.2, -0.77);
    scene->Mapper->AddClippingPlane(plane);
    return scene;
  };
  CheckPicture("SoftShadowShells", make, { LightFromTheOtherSide(), NoShadow(), HalfTheDensity() });
}
