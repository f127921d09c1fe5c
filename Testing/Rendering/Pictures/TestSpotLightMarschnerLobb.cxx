#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
Fault WiderCone()
{
  return { "wider cone", [](IlluminatedScene& scene) { scene.GetLight()->SetConeAngle(28.0); } };
}
}

// A cone of light on the waves of Marschner and Lobb.
TEST_CASE("Picture: spot light marschner lobb", "[picture]")
{
  const SceneMaker make = []
  {
    VolumeGrid grid;
    grid.dimensions = { 41, 41, 41 };
    auto scene = std::make_unique<IlluminatedScene>(MakeMarschnerLobb(grid));
    scene->AddPointLight(60.0, 50.0, 60.0, vtkVolumeLight::Soft);
    scene->GetLight()->SetFocalPoint(20.0, 20.0, 20.0);
    scene->GetLight()->SetConeAngle(14.0);
    scene->GetLight()->SetExponent(4.0);
    scene->GetLight()->SetDiffuseColor(1.0, 0.9, 0.6);
    return scene;
  };
  CheckPicture("SpotLightMarschnerLobb", make, { WiderCone(), NoShadow(), HalfTheDensity() });
}
