#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkVolumeProperty.h>

#include <cmath>

using namespace penumbra;

// In even matter of opacity a per unit distance, the view along an axis from d before the border
// gathers the colour times 1 - (1 - a)^d.
TEST_CASE("Camera: within matter a view ray begins at the eye", "[camera]")
{
  const bool parallel = GENERATE(false, true);
  const double depth = GENERATE(0.5, 3.0, 12.5, 30.0);
  const double scale = GENERATE(1e-3, 1.0, 1e3);
  VolumeGrid grid;
  grid.dimensions = { 40, 40, 40 };
  grid.spacing = { scale, scale, scale };
  IlluminatedScene scene(SampleField(grid, [](const Point&) { return 100.0; }), 33, 33);
  scene.Shade(false);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.0, 0.05);
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(0.0, 0.9, 0.6, 0.3);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(scale);

  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(19.0 * scale, 20.0 * scale, depth * scale);
  camera->SetFocalPoint(19.0 * scale, 20.0 * scale, -10.0 * scale);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(5.0 * scale);
  camera->SetClippingRange(0.01 * scale, 100.0 * scale);
  const double red = scene.Render()->GetScalarComponentAsDouble(16, 16, 0, 0) / 255.0;
  // Half a grey level of rounding.
  CHECK(red == Approx(0.9 * (1.0 - std::pow(0.95, depth))).margin(0.5 / 255.0 + 1e-4));
}
