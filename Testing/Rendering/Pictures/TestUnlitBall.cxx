#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

// Emission and absorption alone.
TEST_CASE("Picture: unlit ball", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 48, 48, 48 } }, 20.0, 8.0));
    scene->Shade(false);
    return scene;
  };
  CheckPicture("UnlitBall", make, { HalfTheDensity() });
}
