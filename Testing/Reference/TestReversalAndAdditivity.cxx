#include "BumpsScene.h"
#include "Catch.h"

#include <vtkMath.h>

#include <cmath>

using namespace penumbra;

TEST_CASE("As much light gets through from either end")
{
  ReferenceScene scene = MakeBumpsScene();
  scene.Optics = OpticalModel::Absorption;
  scene.Property->SetScalarOpacityUnitDistance(8.0);
  for (const Point& direction :
    { Point{ 0.4, 0.7, -1.0 }, Point{ 1.0, 0.0, 0.0 }, Point{ -0.2, 1.0, 0.1 } })
  {
    const Point middle = { 3.1, 3.6, 4.2 };
    scene.Camera = MakeParallelCamera(middle, direction);
    const double there = ComputeMiddle(scene, 1e-6).Color[3];
    scene.Camera = MakeParallelCamera(middle, { -direction[0], -direction[1], -direction[2] });
    const double back = ComputeMiddle(scene, 1e-6).Color[3];
    CHECK(there > 0.01);
    CHECK(there < 0.99);
    CHECK(there == Approx(back).epsilon(1e-8));
  }
}

TEST_CASE("A picture by two lights is the sum of those by each")
{
  ReferenceScene both = MakeBumpsScene();
  both.Property->SetAmbient(0.0);
  // Dim enough that no sample is clamped.
  both.Property->SetDiffuse(0.4);
  const std::string shadow = GENERATE("soft", "hard");
  for (const auto& light : both.Lights)
  {
    auto* volumeLight = vtkVolumeLight::SafeDownCast(light);
    volumeLight->SetShadow(shadow == "soft" ? vtkVolumeLight::Soft : vtkVolumeLight::Hard);
    volumeLight->SetOpacityThreshold(0.4);
  }
  ReferenceScene first = both;
  ReferenceScene second = both;
  first.Lights.pop_back();
  second.Lights.erase(second.Lights.begin());
  ReferenceOptions options;
  options.Tolerance = 0.01;
  const ReferenceIntegrator integrators[] = { ReferenceIntegrator(both, options),
    ReferenceIntegrator(first, options), ReferenceIntegrator(second, options) };
  for (const double x : { 5.5, 7.0, 8.0, 9.5 })
  {
    const double y = 15.0 - x;
    const double sum =
      integrators[1].ComputePixel(x, y).Color[0] + integrators[2].ComputePixel(x, y).Color[0];
    const double together = integrators[0].ComputePixel(x, y).Color[0];
    CAPTURE(shadow, x);
    CHECK(together > 0.02);
    CHECK(together == Approx(sum).margin(3.0 * options.Tolerance / 255.0));
  }
}

TEST_CASE("Perspective and parallel projection agree on a ray they share")
{
  ReferenceScene scene = MakeBumpsScene();
  const double parallel = ComputeMiddle(scene, 0.01).Color[0];
  scene.Camera->ParallelProjectionOff();
  scene.Camera->SetViewAngle(1.0);
  CHECK(ComputeMiddle(scene, 0.01).Color[0] == Approx(parallel).margin(0.02 / 255.0));
}

TEST_CASE("A picture's corner is where the view angle or the parallel scale says")
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, 2 };
  grid.spacing = { 4.0, 4.0, 4.0 };
  const auto volume = SampleField(grid, [](const Point&) { return 1.0; });
  ReferenceScene scene = MakeScene(volume, MakeMaterial({ { 0.0, 0.5 } }, 1.0));
  scene.Size = { 200, 100 };
  scene.Camera = MakeParallelCamera({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, -1.0 }, 10.0);
  const ReferenceIntegrator parallel(scene);
  // 10 pixels are 2 long: the box is from (100, 50) to (120, 70).
  CHECK(parallel.ComputePixel(119.99, 69.99).Color[3] > 0.5);
  CHECK(parallel.ComputePixel(100.01, 50.01).Color[3] > 0.5);
  CHECK(parallel.ComputePixel(120.01, 69.99).Color[3] == 0.0);
  CHECK(parallel.ComputePixel(119.99, 70.01).Color[3] == 0.0);
  CHECK(parallel.ComputePixel(99.99, 50.01).Color[3] == 0.0);
  scene.Camera->ParallelProjectionOff();
  scene.Camera->SetPosition(0.0, 0.0, 4.0 + 50.0);
  scene.Camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(10.0 / 50.0)));
  const ReferenceIntegrator perspective(scene);
  CHECK(perspective.ComputePixel(119.99, 69.99).Color[3] > 0.0);
  CHECK(perspective.ComputePixel(120.01, 69.99).Color[3] == 0.0);
  CHECK(perspective.ComputePixel(119.99, 70.01).Color[3] == 0.0);
}
