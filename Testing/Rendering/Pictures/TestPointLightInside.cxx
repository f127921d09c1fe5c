#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
Fault LightMoved()
{
  return { "light on the other side",
    [](IlluminatedScene& scene) { scene.GetLight()->SetPosition(17.0, 17.0, 9.0); } };
}
}

// A point light between shells that weakens with distance.
TEST_CASE("Picture: point light inside", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeShells({ { 48, 48, 48 } }, 16.0));
    scene->AddPointLight(30.0, 30.0, 38.0, vtkVolumeLight::Soft);
    scene->GetLight()->SetAttenuationValues(0.5, 0.02, 0.0);
    return scene;
  };
  CheckPicture("PointLightInside", make, { LightMoved(), NoShadow(), HalfTheDensity() });
}
