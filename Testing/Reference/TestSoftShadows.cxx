#include "Catch.h"
#include "ReferenceScenes.h"

#include <cmath>

using namespace penumbra;

namespace
{
/// Wide layers along z, seen from above; the scalar rises or falls from layer to layer.
vtkSmartPointer<vtkImageData> MakeLayers(int samples, const ScalarField& field)
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, samples };
  grid.spacing = { 1e5, 1e5, 1.0 };
  grid.origin = { -5e4, -5e4, 0.0 };
  grid.scalarType = VTK_DOUBLE;
  return SampleField(grid, field);
}

ReferenceScene MakeLitLayers(vtkImageData* volume, vtkVolumeProperty* property, vtkLight* light)
{
  property->ShadeOn();
  ReferenceScene scene = MakeScene(volume, property);
  scene.Lights = { light };
  return scene;
}

/// s(z) = 0.5 exp(-0.02 (400 - z)) over 400 layers: the opacity itself is the scalar.
double GetExtinction(double z)
{
  return 0.5 * std::exp(-0.02 * (400.0 - z));
}
}

TEST_CASE("A soft shadow deepens in homogeneous matter by its extinction")
{
  const double bias = GENERATE(0.0, 1.7, 50.0);
  const double s = GENERATE(0.05, 0.6);
  const auto volume = MakeLayers(21, [](const Point& p) { return 20.0 - p[2]; });
  const auto light = MakeDirectionalLight({ 0.0, 0.0, -1.0 });
  light->SetShadowToSoft();
  light->SetShadowBias(bias);
  const auto scene =
    MakeLitLayers(volume, MakeMaterial({ { 0.0, 1.0 - std::exp(-s) } }, 1.0), light);
  const double lit = std::min(bias, 20.0);
  const double expected = 1.0 - std::exp(-s * lit) +
    0.5 * std::exp(s * lit) * (std::exp(-2.0 * s * lit) - std::exp(-40.0 * s));
  const ReferencePixel pixel = ComputeMiddle(scene);
  CHECK(std::abs(pixel.Color[0] - expected) * 255.0 <= pixel.Error + 1e-9);
  CHECK(pixel.Converged);
}

TEST_CASE("A slanting soft shadow in an exponential medium has its closed form")
{
  const Point direction =
    GENERATE(Point{ 0.0, 0.0, -1.0 }, Point{ 0.8, 0.0, -0.6 }, Point{ 0.0, 0.6, 0.8 });
  const auto volume =
    MakeLayers(401, [](const Point& p) { return 1.0 - std::exp(-GetExtinction(p[2])); });
  const auto light = MakeDirectionalLight(direction);
  light->SetShadowToSoft();
  light->SetShadowBias(0.0);
  auto scene = MakeLitLayers(volume, MakeMaterial({ { 0.0, 0.0 }, { 1.0, 1.0 } }, 1.0), light);
  scene.TwoSidedLighting = true;
  const double depth = (0.5 - GetExtinction(0.0)) / 0.02;
  const double cosine = std::abs(direction[2]);
  // From above the depths of light and view add up, from below they grow against each other.
  const double slope = direction[2] < 0.0 ? 1.0 + 1.0 / cosine : 1.0 - 1.0 / cosine;
  const double atTop = direction[2] < 0.0 ? 0.0 : depth / cosine;
  const double expected = cosine * std::exp(-atTop) * (1.0 - std::exp(-slope * depth)) / slope;
  // Linear interpolation between the layers is off by 1e-4 / 12 of the depth.
  CHECK(ComputeMiddle(scene).Color[0] == Approx(expected).margin(3e-5).epsilon(3e-4));
}

TEST_CASE("A soft shadow begins where the light is")
{
  const auto volume = MakeLayers(21, [](const Point& p) { return 20.0 - p[2]; });
  const auto light = MakePointLight({ 0.0, 0.0, 12.0 });
  light->SetShadowToSoft();
  light->SetShadowBias(0.0);
  auto scene = MakeLitLayers(volume, MakeMaterial({ { 0.0, 1.0 - std::exp(-0.1) } }, 1.0), light);
  scene.TwoSidedLighting = true;
  // Above the light 8 thick, with the light's shadow growing upwards; below 12.
  const double above = 0.1 * 8.0 * std::exp(-0.8);
  const double below = 0.5 * std::exp(-0.8) * (1.0 - std::exp(-2.4));
  CHECK(ComputeMiddle(scene).Color[0] == Approx(above + below).margin(1e-5));
}

TEST_CASE("What is clipped casts no shadow")
{
  const auto volume = MakeLayers(21, [](const Point& p) { return 20.0 - p[2]; });
  const auto light = MakeDirectionalLight({ 0.0, 0.0, 1.0 });
  light->SetShadowToSoft();
  light->SetShadowBias(0.0);
  auto scene = MakeLitLayers(volume, MakeMaterial({ { 0.0, 1.0 - std::exp(-0.1) } }, 1.0), light);
  scene.TwoSidedLighting = true;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 13.0);
  plane->SetNormal(0.0, 0.0, 2.0);
  scene.ClippingPlanes = { plane.Get() };
  CHECK(ComputeMiddle(scene).Color[0] == Approx(0.7 * std::exp(-0.7)).margin(1e-5));
  scene.ClippingPlanes.clear();
  scene.Cropping = { { -1e9, 1e9, -1e9, 1e9, 13.0, 18.0 } };
  CHECK(ComputeMiddle(scene).Color[0] == Approx(0.5 * std::exp(-0.5)).margin(1e-5));
}
