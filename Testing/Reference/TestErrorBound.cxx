#include "BumpsScene.h"
#include "Catch.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>

#include <cmath>

using namespace penumbra;

namespace
{
/// A scene that is hard on the integrator, by its name.
ReferenceScene MakeHardScene(const std::string& name)
{
  ReferenceScene scene = MakeBumpsScene();
  if (name == "hard shadows")
  {
    for (const auto& light : scene.Lights)
    {
      auto* volumeLight = vtkVolumeLight::SafeDownCast(light);
      volumeLight->SetShadowToHard();
      volumeLight->SetOpacityThreshold(0.3);
    }
  }
  else if (name == "gradient opacity")
  {
    vtkNew<vtkPiecewiseFunction> function;
    function->AllowDuplicateScalarsOn();
    function->AddPoint(0.0, 0.0);
    function->AddPoint(20.0, 0.3);
    function->AddPoint(20.0, 0.6);
    function->AddPoint(60.0, 1.0);
    scene.Property->SetGradientOpacity(function);
  }
  else if (name == "a light within")
  {
    const auto light = MakePointLight({ 3.2, 4.1, 5.3 });
    light->SetConeAngle(75.0);
    light->SetIntensity(6.0);
    light->SetAttenuationValues(0.1, 0.1, 0.2);
    light->SetShadowToSoft();
    scene.Lights = { light };
  }
  else if (name == "nearest voxels")
  {
    scene.Property->SetInterpolationTypeToNearest();
  }
  else if (name == "steep")
  {
    scene.Property->SetScalarOpacityUnitDistance(0.01);
  }
  return scene;
}

std::vector<ReferencePixel> ComputePixels(const ReferenceScene& scene, double tolerance)
{
  ReferenceOptions options;
  options.Tolerance = tolerance;
  const ReferenceIntegrator integrator(scene, options);
  std::vector<ReferencePixel> pixels;
  for (int y = 0; y < scene.Size[1]; y += 2)
  {
    for (int x = 0; x < scene.Size[0]; x += 2)
    {
      pixels.push_back(integrator.ComputePixel(x + 0.5, y + 0.5));
    }
  }
  return pixels;
}

double GetLargestDifference(const ReferencePixel& pixel, const ReferencePixel& other)
{
  double largest = 0.0;
  for (int channel = 0; channel < 4; ++channel)
  {
    largest = std::max(largest, std::abs(pixel.Color[channel] - other.Color[channel]) * 255.0);
  }
  return largest;
}
}

TEST_CASE("The tolerance is kept, and the error bounds hold, against pictures that are far better")
{
  const std::string name = GENERATE(as<std::string>{}, "soft shadows", "hard shadows",
    "gradient opacity", "a light within", "nearest voxels", "steep");
  const ReferenceScene scene = MakeHardScene(name);
  const std::vector<ReferencePixel> best = ComputePixels(scene, 1e-4);
  for (const double tolerance : { 1.0, 0.05 })
  {
    CAPTURE(name, tolerance);
    const std::vector<ReferencePixel> pixels = ComputePixels(scene, tolerance);
    double lit = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
    {
      const double difference = GetLargestDifference(pixels[i], best[i]);
      CHECK(pixels[i].Converged);
      CHECK(pixels[i].Error <= tolerance);
      CHECK(difference <= pixels[i].Error + best[i].Error);
      lit += pixels[i].Color[0];
    }
    CHECK(lit / pixels.size() > 0.01);
  }
}

TEST_CASE("A better tolerance takes more samples")
{
  const ReferenceScene scene = MakeBumpsScene();
  CHECK(ComputeMiddle(scene, 1e-4).Samples > 1.5 * ComputeMiddle(scene, 1.0).Samples);
}

TEST_CASE("A pixel that needs too many samples is given up, and says so")
{
  const ReferenceScene scene = MakeBumpsScene();
  ReferenceOptions options;
  options.Tolerance = 1e-7;
  options.MostSamplesPerPixel = 200;
  const ReferencePixel pixel = ReferenceIntegrator(scene, options).ComputePixel(8.0, 8.0);
  CHECK_FALSE(pixel.Converged);
  CHECK(pixel.Error > options.Tolerance);
  CHECK(pixel.Samples < 400);
  const auto picture = ReferenceIntegrator(scene, options).Render();
  REQUIRE(picture);
  CHECK(picture->Statistics.PixelsNotConverged > 10);
  CHECK(picture->Statistics.LargestError > options.Tolerance);
}
