#include "Catch.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"

using namespace penumbra;

namespace
{
using Color = std::array<double, 3>;
const Color Black = { 0.0, 0.0, 0.0 };
const Color White = { 1.0, 1.0, 1.0 };
}

TEST_CASE("Ambient light is the sum of colours times intensities")
{
  const auto first = MakeLight(LightKind::Point, ShadowKind::Soft);
  first->SetAmbientColor(0.25, 0.5, 0.0);
  first->SetIntensity(2.0);
  const auto second = MakeLight(LightKind::Directional, ShadowKind::None);
  second->SetAmbientColor(0.125, 0.0, 0.75);
  const LightsAndMaterial with({ first, second });
  CHECK(ComputeAmbientLight(with.lights) == Color{ 0.625, 1.0, 0.75 });
  second->SwitchOff();
  CHECK(ComputeAmbientLight(with.lights) == Color{ 0.5, 1.0, 0.0 });
  second->SwitchOn();
  second->SetIntensity(0.0);
  CHECK(ComputeAmbientLight(with.lights) == Color{ 0.5, 1.0, 0.0 });
}

TEST_CASE("No light that is on gives no ambient light")
{
  CHECK(ComputeAmbientLight(nullptr) == Black);
  CHECK(ComputeAmbientLight(LightsAndMaterial().lights) == Black);
  vtkNew<vtkLight> off;
  off->SwitchOff();
  CHECK(ComputeAmbientLight(LightsAndMaterial({ off.Get() }).lights) == Black);
}

TEST_CASE("Where all lights are plain ones with black ambient colour, ambient light is white")
{
  vtkNew<vtkLight> first;
  vtkNew<vtkLight> second;
  second->SetIntensity(3.0);
  const LightsAndMaterial with({ first.Get(), second.Get() });
  CHECK(ComputeAmbientLight(with.lights) == White);
  // One that has a colour makes it the sum again.
  second->SetAmbientColor(0.0, 0.125, 0.0);
  CHECK(ComputeAmbientLight(with.lights) == Color{ 0.0, 0.375, 0.0 });
  second->SwitchOff();
  CHECK(ComputeAmbientLight(with.lights) == White);
}

TEST_CASE("A volume light among plain ones makes ambient light the sum")
{
  vtkNew<vtkLight> plain;
  const auto light = MakeLight(LightKind::Point, ShadowKind::None);
  light->SetAmbientColor(0.0, 0.0, 0.0);
  const LightsAndMaterial with({ plain.Get(), light });
  CHECK(ComputeAmbientLight(with.lights) == Black);
  light->SetAmbientColor(0.5, 0.25, 0.125);
  CHECK(ComputeAmbientLight(with.lights) == Color{ 0.5, 0.25, 0.125 });
  light->SwitchOff();
  CHECK(ComputeAmbientLight(with.lights) == White);
}
