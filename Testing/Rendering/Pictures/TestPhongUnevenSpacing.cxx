#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
// Two-sided lighting would flip the normal to a light from behind; one-sided must not.
Fault OneSidedFromBehind()
{
  return { "one-sided, light from the other side",
    [](IlluminatedScene& scene)
    {
      scene.Renderer->TwoSidedLightingOff();
      LightFromTheOtherSide().Break(scene);
    } };
}
}

// Phong shading where the extents are not equal.
TEST_CASE("Picture: phong uneven spacing", "[picture]")
{
  const SceneMaker make = []
  {
    VolumeGrid grid;
    grid.dimensions = { 48, 48, 32 };
    grid.spacing = { 1.0, 1.0, 2.25 };
    auto scene = std::make_unique<IlluminatedScene>(MakeBall(grid, 20.0, 8.0));
    scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::None);
    return scene;
  };
  CheckPicture("PhongUnevenSpacing", make, { HalfTheDensity(), OneSidedFromBehind() });
}
