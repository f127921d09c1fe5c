#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>

using namespace penumbra;

// Rays that run exactly within a face of the box have their whole way or, where the rasterizer
// leaves the pixel out, none of it.
TEST_CASE("Border: rays within a face of the box are not cut short", "[border]")
{
  const int axis = GENERATE(0, 1, 2);
  const double side = GENERATE(-1.0, 1.0);
  IlluminatedScene scene(
    SampleField({ { 64, 64, 64 } }, [](const Point&) { return 100.0; }), 64, 64);
  scene.Shade(false);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.05);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double position[3] = { 31.5, 31.5, 31.5 };
  camera->SetFocalPoint(position);
  position[axis] += 128.0 * side;
  camera->SetPosition(position);
  camera->SetViewUp(axis == 1 ? 1.0 : 0.0, axis == 1 ? 0.0 : 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(32.0); // pixels' centres are voxels' centres
  camera->SetClippingRange(32.0, 224.0);
  const auto picture = scene.Render();
  const double inside = picture->GetScalarComponentAsDouble(32, 32, 0, 0);
  REQUIRE(inside > 50.0);
  for (int row = 0; row < 64; ++row)
  {
    for (int column = 0; column < 64; ++column)
    {
      const double value = picture->GetScalarComponentAsDouble(column, row, 0, 0);
      CHECK((value == 0.0 || value == Approx(inside).margin(1.0)));
    }
  }
}
