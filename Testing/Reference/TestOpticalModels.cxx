#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkColorTransferFunction.h>

#include <cmath>

using namespace penumbra;

namespace
{
ReferenceScene MakeOrangeBox(OpticalModel optics)
{
  VolumeGrid grid;
  grid.dimensions = { 4, 4, 6 };
  const auto material = MakeMaterial({ { 0.0, 0.2 } }, 2.0);
  vtkNew<vtkColorTransferFunction> orange;
  orange->AddRGBPoint(0.0, 0.9, 0.5, 0.1);
  material->SetColor(orange);
  ReferenceScene scene = MakeScene(SampleField(grid, [](const Point&) { return 1.0; }), material);
  scene.Optics = optics;
  scene.Background = { 0.2, 0.4, 0.05 };
  return scene;
}

constexpr double Length = 5.0;
const double Depth = -std::log(0.8) * Length / 2.0;
}

TEST_CASE("Absorption dims the background")
{
  const auto scene = MakeOrangeBox(OpticalModel::Absorption);
  const auto color = ComputeMiddle(scene).Color;
  for (int channel = 0; channel < 3; ++channel)
  {
    CHECK(color[channel] == Approx(scene.Background[channel] * std::exp(-Depth)).margin(1e-6));
  }
  CHECK(color[3] == Approx(1.0 - std::exp(-Depth)).margin(1e-6));
}

TEST_CASE("Emission adds to the background, up to white")
{
  auto scene = MakeOrangeBox(OpticalModel::Emission);
  const double emitted[] = { 0.9, 0.5, 0.1 };
  auto color = ComputeMiddle(scene).Color;
  for (int channel = 0; channel < 3; ++channel)
  {
    CHECK(
      color[channel] == Approx(scene.Background[channel] + emitted[channel] * Depth).margin(1e-6));
  }
  CHECK(color[3] == 0.0);
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  const ReferencePixel bright = ComputeMiddle(scene);
  CHECK(bright.Color[0] == 1.0);
  CHECK(bright.Color[2] == Approx(0.05 + 0.1 * 4.0 * Depth).margin(1e-6));
  scene.Property->SetScalarOpacityUnitDistance(1e-6);
  CHECK(ComputeMiddle(scene).Color[2] == 1.0);
  CHECK(ComputeMiddle(scene).Converged);
}

TEST_CASE("Absorption and emission lets the colour through that is before")
{
  const auto scene = MakeOrangeBox(OpticalModel::AbsorptionEmission);
  const auto color = ComputeMiddle(scene).Color;
  const double alpha = 1.0 - std::exp(-Depth);
  CHECK(color[0] == Approx(0.9 * alpha + 0.2 * (1.0 - alpha)).margin(1e-6));
  CHECK(color[3] == Approx(alpha).margin(1e-6));
}

TEST_CASE("Where the scene does not say, shading decides")
{
  auto scene = MakeOrangeBox(OpticalModel::AbsorptionEmission);
  const double unlit = ComputeMiddle(scene).Color[0];
  scene.Optics.reset();
  CHECK(ComputeMiddle(scene).Color[0] == unlit);
  scene.Property->ShadeOn();
  // No light is on.
  CHECK(ComputeMiddle(scene).Color[0] == Approx(0.2 * std::exp(-Depth)).margin(1e-6));
}
