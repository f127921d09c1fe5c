#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

using namespace penumbra;

namespace
{
// Unlike its mirror image.
vtkSmartPointer<vtkImageData> MakeBallAndKnob()
{
  const auto ball = [](const Point& p, const Point& center, double radius)
  {
    const double distance = std::hypot(p[0] - center[0], p[1] - center[1], p[2] - center[2]);
    return std::clamp(0.5 - (distance - radius) / 5.0, 0.0, 1.0);
  };
  return SampleField({ { 48, 48, 48 } },
    [&](const Point& p) {
      return 255.0 * std::max(ball(p, { 23, 21, 20 }, 14.0), ball(p, { 36, 34, 34 }, 6.0));
    });
}

Fault NotMirrored()
{
  return { "not mirrored",
    [](IlluminatedScene& scene)
    {
      scene.Volume->SetScale(1.0, 1.0, 1.0);
      scene.Volume->SetPosition(-47.0, 0.0, 0.0);
    } };
}
}

// A mirroring actor, turned, in parallel projection.
TEST_CASE("Picture: parallel mirrored", "[picture]")
{
  const SceneMaker make = []
  {
    auto scene = std::make_unique<IlluminatedScene>(MakeBallAndKnob());
    scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
    scene->Volume->SetScale(-1.0, 1.0, 1.0);
    scene->Volume->RotateY(25.0);
    scene->Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene->Renderer->GetActiveCamera()->SetParallelScale(34.0);
    const double target[3] = { -20.0, 20.0, 12.0 };
    scene->LookFrom(0.4, 0.3, 0.85, 100.0, target);
    return scene;
  };
  CheckPicture("ParallelMirrored", make,
    { NotMirrored(), LightFromTheOtherSide(), NoShadow(), HalfTheDensity() });
}
