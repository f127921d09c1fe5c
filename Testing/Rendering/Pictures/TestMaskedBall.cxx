#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

using namespace penumbra;

namespace
{
vtkSmartPointer<vtkImageData> MakeMask()
{
  return SampleField({ { 40, 40, 40 } },
    [](const Point& p) { return p[0] > 19.5 && p[1] > 19.5 && p[2] > 19.5 ? 0.0 : 1.0; });
}

Fault NoMask()
{
  return { "no mask", [](IlluminatedScene& scene) { scene.Mapper->SetMaskInput(nullptr); } };
}
}

// A mask hides an eighth of a ball; what it hides casts no shadow.
TEST_CASE("Picture: masked ball", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeBall({ { 40, 40, 40 } }, 17.0, 6.0));
    scene->AddDirectionalLight(-0.2, -1.0, -0.3, vtkVolumeLight::Soft);
    scene->Mapper->SetMaskInput(MakeMask());
    scene->Mapper->SetMaskTypeToBinary();
    return scene;
  };
  CheckPicture("MaskedBall", make, { NoMask(), NoShadow(), HalfTheDensity() });
}
