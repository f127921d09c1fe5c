#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

#include <algorithm>

using namespace penumbra;

namespace
{
// Smooth-edged, so that normals are.
vtkSmartPointer<vtkImageData> MakeFloorAndBar()
{
  const auto box = [](const Point& p, const Point& low, const Point& high)
  {
    double distance = -1e9;
    for (int axis = 0; axis < 3; ++axis)
    {
      distance = std::max({ distance, low[axis] - p[axis], p[axis] - high[axis] });
    }
    return std::clamp(0.5 - distance / 4.0, 0.0, 1.0);
  };
  return SampleField({ { 48, 48, 48 } },
    [&](const Point& p)
    {
      return 255.0 *
        std::max(box(p, { 4, 4, 4 }, { 43, 10, 43 }), box(p, { 18, 30, 8 }, { 24, 35, 38 }));
    });
}
}

// A bar throws a sharp shadow on a floor.
TEST_CASE("Picture: hard shadow bar", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeFloorAndBar());
    scene->AddDirectionalLight(-0.3, -1.0, -0.1, vtkVolumeLight::Hard);
    scene->GetLight()->SetShadowBias(2.0);
    scene->GetLight()->SetOpacityThreshold(0.9);
    return scene;
  };
  CheckPicture("HardShadowBar", make, { LightFromTheOtherSide(), NoShadow(), HalfTheDensity() });
}
