#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkColorTransferFunction.h>

#include <cmath>

using namespace penumbra;

namespace
{
/// The scalar is z, from 0 to 10, seen from above; interpolation is exact.
vtkSmartPointer<vtkImageData> MakeRampAlongZ(int samples = 11, double last = 10.0)
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, samples };
  grid.spacing = { 8.0, 8.0, last / (samples - 1) };
  grid.scalarType = VTK_DOUBLE;
  return SampleField(grid, [](const Point& p) { return p[2]; });
}

/// Integral of -ln(1 - a) where a rises linearly from `first` to `last` over a length of 1.
double GetDepthOfRamp(double first, double last)
{
  const auto antiderivative = [](double a)
  { return a < 1.0 ? (1.0 - a) * (std::log(1.0 - a) - 1.0) : 0.0; };
  return (antiderivative(last) - antiderivative(first)) / (last - first);
}

double GetError(const ReferencePixel& pixel, double alpha)
{
  return std::abs(pixel.Color[3] - alpha) * 255.0;
}
}

TEST_CASE("A linear ramp of opacity has its integral's transmittance")
{
  const double steepness = GENERATE(0.02, 0.1, 0.9999, 7.0);
  const double unit = GENERATE(1.0, 4.0);
  const double width = std::min(10.0, 0.999 / steepness);
  const double top = steepness * width;
  // Up from 0 within the volume, and down again at once.
  const auto material =
    MakeMaterial({ { 0.0, 0.0 }, { width, top }, { width, 0.0 }, { 11.0, 0.0 } }, unit);
  const double depth = width * GetDepthOfRamp(0.0, top) / unit;
  const ReferencePixel pixel = ComputeMiddle(MakeScene(MakeRampAlongZ(), material));
  CAPTURE(steepness, unit, pixel.Error);
  CHECK(GetError(pixel, 1.0 - std::exp(-depth)) <= pixel.Error + 1e-9);
  CHECK(pixel.Converged);
}

TEST_CASE("Full opacity counts as 1 - 2^-24")
{
  const double length = GENERATE(1e-3, 0.03, 0.3);
  const auto material =
    MakeMaterial({ { 4.0, 0.0 }, { 4.0, 1.0 }, { 4.0 + length, 1.0 }, { 4.0 + length, 0.0 } }, 1.0);
  const double alpha = 1.0 - std::exp(-24.0 * std::log(2.0) * length);
  const ReferencePixel pixel = ComputeMiddle(MakeScene(MakeRampAlongZ(), material));
  CHECK(GetError(pixel, alpha) <= 1e-6);
}

TEST_CASE("No peak of a transfer function is overlooked, however narrow")
{
  // One scalar value wide in a range of 16 bits, within one of ten cells.
  const double width = GENERATE(1.0, 1e-3);
  const double peak = 31234.0;
  const auto material =
    MakeMaterial({ { peak - width, 0.0 }, { peak, 0.9 }, { peak + width, 0.0 }, { 65535.0, 0.0 } },
      width / 65535.0);
  auto volume = MakeRampAlongZ(11, 65535.0);
  volume->SetSpacing(8.0, 8.0, 1.0 / 10.0);
  const double depth = 2.0 * GetDepthOfRamp(0.0, 0.9);
  const ReferencePixel pixel = ComputeMiddle(MakeScene(volume, material));
  CHECK(GetError(pixel, 1.0 - std::exp(-depth)) <= 1e-3);
}

TEST_CASE("At a step the function has its first point's value, beyond its ends that of the end")
{
  VolumeGrid grid;
  grid.dimensions = { 2, 2, 2 };
  const auto atStep = SampleField(grid, [](const Point&) { return 100.0; });
  const auto material = MakeMaterial({ { 50.0, 0.4 }, { 100.0, 0.2 }, { 100.0, 0.6 } }, 1.0);
  CHECK(ComputeMiddle(MakeScene(atStep, material)).Color[3] == Approx(0.2));
  const auto above = SampleField(grid, [](const Point&) { return 200.0; });
  CHECK(ComputeMiddle(MakeScene(above, material)).Color[3] == Approx(0.6));
  const auto below = SampleField(grid, [](const Point&) { return 10.0; });
  CHECK(ComputeMiddle(MakeScene(below, material)).Color[3] == Approx(0.4));
}

TEST_CASE("A ramp of colour in homogeneous matter has its closed form")
{
  const auto material = MakeMaterial({ { 0.0, 0.2 } }, 1.0);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AllowDuplicateScalarsOn();
  colors->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  colors->AddRGBPoint(5.3, 1.0, 0.0, 0.0);
  colors->AddRGBPoint(5.3, 0.0, 1.0, 0.0);
  colors->AddRGBPoint(10.0, 0.0, 1.0, 1.0);
  material->SetColor(colors);
  const ReferencePixel pixel = ComputeMiddle(MakeScene(MakeRampAlongZ(), material));
  const double s = -std::log(0.8);
  const double first = std::exp(-4.7 * s);
  const double last = std::exp(-10.0 * s);
  CHECK(pixel.Color[0] == Approx(first - last).margin(2e-6));
  CHECK(pixel.Color[1] == Approx(1.0 - first).margin(2e-6));
  // Blue is (4.7 - depth) / 4.7 down to the step.
  const double blue = 1.0 - (1.0 - first) / (4.7 * s);
  CHECK(pixel.Color[2] == Approx(blue).margin(2e-6));
}
