#include "Catch.h"
#include "IlluminatedScene.h"
#include "SyntheticVolumes.h"

#include <vtkCamera.h>
#include <vtkVolumeProperty.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Opacity = 0.05;
constexpr double Depth = 16.0;
constexpr double UnitDistance = 2.0;
const double Color[3] = { 0.9, 0.5, 0.1 };
const double Background[3] = { 0.2, 0.6, 0.4 };

// A slab of one value, seen along its 16 voxels of depth: an optical depth of s Depth.
double ExtinctionTimesDepth()
{
  return -std::log(1.0 - Opacity) / UnitDistance * Depth;
}

std::unique_ptr<IlluminatedScene> MakeSlabScene(int opticalModel)
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 17 };
  grid.spacing = { 100.0, 100.0, 1.0 };
  auto scene = std::make_unique<IlluminatedScene>(MakeSlab(grid, 2, -1.0, 20.0), 32, 32);
  scene->Renderer->SetBackground(Background[0], Background[1], Background[2]);
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, Opacity);
  scene->Color->RemoveAllPoints();
  scene->Color->AddRGBPoint(0.0, Color[0], Color[1], Color[2]);
  scene->Volume->GetProperty()->SetScalarOpacityUnitDistance(UnitDistance);
  scene->AddDirectionalLight(0.0, 0.0, -1.0, vtkVolumeLight::Soft);
  scene->Mapper->SetOpticalModel(opticalModel);
  const double center[3] = { 100.0, 100.0, 8.0 };
  scene->LookFrom(0.0, 0.0, 1.0, 1000.0, center);
  scene->Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene->Renderer->GetActiveCamera()->SetParallelScale(50.0);
  return scene;
}

using Expected = std::function<double(double color, double background)>;

void CheckMiddle(IlluminatedScene& scene, const Expected& expected)
{
  const auto picture = scene.Render();
  for (int channel = 0; channel < 3; ++channel)
  {
    const double level = 255.0 * std::min(expected(Color[channel], Background[channel]), 1.0);
    // Half a grey level of rounding, and the eight bits of the background.
    CHECK(picture->GetScalarComponentAsDouble(16, 16, 0, channel) == Approx(level).margin(1.0));
  }
}
}

TEST_CASE("Absorption: L = background T")
{
  const auto scene = MakeSlabScene(vtkIlluminatedVolumeMapper::Absorption);
  CheckMiddle(*scene,
    [](double, double background) { return background * std::exp(-ExtinctionTimesDepth()); });
}

TEST_CASE("Emission: L = background + s C times the depth, at most 1")
{
  const auto scene = MakeSlabScene(vtkIlluminatedVolumeMapper::Emission);
  CheckMiddle(*scene,
    [](double color, double background) { return background + ExtinctionTimesDepth() * color; });
  scene->Opacity->RemoveAllPoints();
  scene->Opacity->AddPoint(0.0, 0.9);
  CheckMiddle(*scene, [](double, double) { return 1.0; });
}

TEST_CASE("Absorption and emission: L = C (1 - T) + background T, whatever the lights")
{
  const auto scene = MakeSlabScene(vtkIlluminatedVolumeMapper::AbsorptionEmission);
  const double transmittance = std::exp(-ExtinctionTimesDepth());
  const Expected expected = [=](double color, double background)
  { return color * (1.0 - transmittance) + background * transmittance; };
  CheckMiddle(*scene, expected);
  scene->Mapper->SetOpticalModelToByShade();
  scene->Volume->GetProperty()->ShadeOff();
  CheckMiddle(*scene, expected);
}

// A ramp too faint to be seen gives a normal towards the light: c = C (ka + kd V), V = exp(-s z).
TEST_CASE("Single scattering: L = C (ka (1 - T) + kd (1 - T^2) / 2) + background T, shade or not")
{
  const auto scene = MakeSlabScene(vtkIlluminatedVolumeMapper::SingleScattering);
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 17 };
  grid.spacing = { 100.0, 100.0, 1.0 };
  grid.scalarType = VTK_FLOAT;
  scene->Mapper->SetInputData(MakeRamp(grid, 2));
  vtkVolumeProperty* property = scene->Volume->GetProperty();
  property->SetAmbient(0.3);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.0);
  property->ShadeOff();
  scene->GetLight()->SetShadowBias(0.0);
  scene->Mapper->SetSampleDistance(0.125f);
  scene->Mapper->SetShadowSampleDistance(0.125);
  const double transmittance = std::exp(-ExtinctionTimesDepth());
  CheckMiddle(*scene,
    [=](double color, double background)
    {
      const double ambient = 0.3 * (1.0 - transmittance);
      const double diffuse = 0.6 * 0.5 * (1.0 - transmittance * transmittance);
      return color * (ambient + diffuse) + background * transmittance;
    });
}
