#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>

using namespace penumbra;

// Rays that run exactly within a face of the box have their whole way or, where the rasterizer leaves
// the pixel out, none of it.
TEST_CASE("Border: rays within a face of the box are not cut short", "[border]")
{
  const int axis = GENERATE(0, 1, 2);
  const double side = GENERATE(-1.0, 1.0);
  IlluminatedScene scene(
    SampleField({ { 33, 33, 33 } }, [](const Point&) { return 100.0; }), 33, 33);
  scene.Shade(false);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.05);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double position[3] = { 16.0, 16.0, 16.0 };
  camera->SetFocalPoint(position);
  position[axis] += 100.0 * side;
  camera->SetPosition(position);
  camera->SetViewUp(axis == 1 ? 1.0 : 0.0, axis == 1 ? 0.0 : 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(16.5); // pixels' centres are voxels' centres
  camera->SetClippingRange(1.0, 300.0);
  const auto picture = scene.Render();
  const double inside = picture->GetScalarComponentAsDouble(16, 16, 0, 0);
  REQUIRE(inside > 50.0);
  for (int row = 0; row < 33; ++row)
  {
    for (int column = 0; column < 33; ++column)
    {
      const double value = picture->GetScalarComponentAsDouble(column, row, 0, 0);
      CHECK((value == 0.0 || value == Approx(inside).margin(1.0)));
    }
  }
}
