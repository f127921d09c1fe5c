#include "Catch.h"
#include "PictureTest.h"
#include "SyntheticVolumes.h"

#include <vtkVolumeProperty.h>

using namespace penumbra;

namespace
{
Fault NoGradientOpacity()
{
  return { "no gradient opacity",
    [](IlluminatedScene& scene) { scene.Volume->GetProperty()->DisableGradientOpacityOn(); } };
}
}

// Only where the gradient is steep is there matter.
TEST_CASE("Picture: gradient opacity ball", "[picture]")
{
  const SceneMaker make = []
  {
    VolumeGrid grid;
    grid.dimensions = { 40, 40, 24 };
    grid.spacing = { 1.0, 1.0, 1.75 };
    auto scene = std::make_unique<IlluminatedScene>(MakeBall(grid, 16.0, 14.0));
    scene->AddDirectionalLight(-0.6, -0.7, -0.4, vtkVolumeLight::Soft);
    scene->Opacity->RemoveAllPoints();
    scene->Opacity->AddPoint(60.0, 0.0);
    scene->Opacity->AddPoint(255.0, 0.08);
    vtkNew<vtkPiecewiseFunction> gradientOpacity;
    gradientOpacity->AddPoint(4.0, 0.0);
    gradientOpacity->AddPoint(24.0, 1.0);
    scene->Volume->GetProperty()->SetGradientOpacity(gradientOpacity);
    return scene;
  };
  CheckPicture("GradientOpacityBall", make, { NoGradientOpacity(), NoShadow(), HalfTheDensity() });
}
