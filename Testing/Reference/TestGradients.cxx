#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkPiecewiseFunction.h>

#include <cmath>

using namespace penumbra;

namespace
{
/// Homogeneous matter of which the scalars give the normal only, lit along -z, so thin that what is
/// seen is a mean over a box of 1e-3 about a point.
double ComputeNormalZ(vtkImageData* volume, GradientEstimator estimator, const Point& at)
{
  const auto material = MakeMaterial({ { 0.0, 1.0 } }, 1e-9);
  material->ShadeOn();
  ReferenceScene scene = MakeScene(volume, material);
  scene.Gradient = estimator;
  scene.Lights = { MakeDirectionalLight({ 0.0, 0.0, -1.0 }) };
  scene.Cropping = { { -1e9, 1e9, -1e9, 1e9, -1e9, at[2] } };
  scene.Camera = MakeParallelCamera(at, { 0.0, 0.0, -1.0 });
  return ComputeMiddle(scene, 1e-3).Color[0];
}

vtkSmartPointer<vtkImageData> MakeField(const ScalarField& field)
{
  VolumeGrid grid;
  grid.dimensions = { 9, 9, 9 };
  grid.spacing = { 1.0, 2.0, 0.5 };
  grid.scalarType = VTK_DOUBLE;
  return SampleField(grid, field);
}

/// Of the normal against the gradient (x, y, z).
double GetNormalZ(double x, double y, double z)
{
  return std::abs(z) / std::hypot(x, y, z);
}
}

TEST_CASE("Every estimator finds a linear field's normal in the world, whatever the spacing")
{
  const auto estimator =
    GENERATE(GradientEstimator::CentralDifferences, GradientEstimator::ForwardDifferences,
      GradientEstimator::BackwardDifferences, GradientEstimator::Sobel);
  const auto volume = MakeField([](const Point& p) { return 3.0 * p[0] - p[1] - 2.0 * p[2]; });
  CHECK(ComputeNormalZ(volume, estimator, { 4.2, 7.3, 2.1 }) ==
    Approx(GetNormalZ(3.0, -1.0, -2.0)).margin(1e-5));
}

TEST_CASE("Differences are of interpolated values one voxel away")
{
  // x rises by its square, z falls by 4: at 3.25 the field interpolates 9 and 16, and so on.
  const auto volume = MakeField([](const Point& p) { return p[0] * p[0] - 4.0 * p[2]; });
  const Point at = { 3.25, 8.0, 2.1 };
  const auto square = [](double x)
  {
    const double below = std::floor(x);
    return below * below + (x - below) * (2.0 * below + 1.0);
  };
  const double central = 0.5 * (square(4.25) - square(2.25));
  CHECK(ComputeNormalZ(volume, GradientEstimator::CentralDifferences, at) ==
    Approx(GetNormalZ(central, 0.0, -4.0)).margin(1e-5));
  CHECK(ComputeNormalZ(volume, GradientEstimator::ForwardDifferences, at) ==
    Approx(GetNormalZ(square(4.25) - square(3.25), 0.0, -4.0)).margin(1e-5));
  CHECK(ComputeNormalZ(volume, GradientEstimator::BackwardDifferences, at) ==
    Approx(GetNormalZ(square(3.25) - square(2.25), 0.0, -4.0)).margin(1e-5));
  CHECK(ComputeNormalZ(volume, GradientEstimator::Sobel, at) ==
    Approx(GetNormalZ(central, 0.0, -4.0)).margin(1e-5));
}

TEST_CASE("At the border the field goes on with its outermost values")
{
  const auto volume = MakeField([](const Point& p) { return 4.0 * p[0] - 3.0 * p[2]; });
  const Point at = { 7.25, 8.0, 2.1 };
  // From 6.25 to 8, not to 8.25.
  CHECK(ComputeNormalZ(volume, GradientEstimator::CentralDifferences, at) ==
    Approx(GetNormalZ(4.0 * 1.75 / 2.0, 0.0, -3.0)).margin(1e-5));
}

TEST_CASE("Sobel's weights across an axis are 1 3 1, 3 6 3, 1 3 1")
{
  // A line of ones along z and a slope along z: beside the line the x derivative is 3 + 6 + 3 or
  // 1 + 3 + 1, over 44.
  const auto volume =
    MakeField([](const Point& p) { return (p[0] == 4.0 && p[1] == 8.0 ? 1.0 : 0.0) - p[2]; });
  const double beside = 12.0 / 44.0;
  const double aslant = 5.0 / 44.0;
  CHECK(ComputeNormalZ(volume, GradientEstimator::Sobel, { 3.0, 8.0, 2.1 }) ==
    Approx(GetNormalZ(beside, 0.0, -1.0)).margin(1e-5));
  CHECK(ComputeNormalZ(volume, GradientEstimator::Sobel, { 3.0, 6.0, 2.1 }) ==
    Approx(GetNormalZ(aslant, aslant / 2.0, -1.0)).margin(1e-5));
}

TEST_CASE("Where there is no gradient there is ambient light only")
{
  VolumeGrid grid;
  grid.dimensions = { 4, 4, 4 };
  const auto material = MakeMaterial({ { 0.0, 0.2 } }, 1.0);
  material->ShadeOn();
  material->SetAmbient(0.25);
  auto scene = MakeScene(SampleField(grid, [](const Point&) { return 7.0; }), material);
  const auto light = MakeDirectionalLight({ 0.0, 0.0, -1.0 });
  light->SetAmbientColor(1.0, 1.0, 1.0);
  scene.Lights = { light };
  const ReferencePixel pixel = ComputeMiddle(scene);
  CHECK(pixel.Color[0] == Approx(0.25 * pixel.Color[3]));
}

TEST_CASE("Gradient opacity is by scalar units per mean voxel")
{
  // The gradient is 8 per length, the mean spacing 3.5 / 3.
  const auto volume = MakeField([](const Point& p) { return 8.0 * p[2]; });
  const auto material = MakeMaterial({ { 0.0, 0.3 } }, 1.0);
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(20.0, 1.0);
  material->SetGradientOpacity(function);
  auto scene = MakeScene(volume, material);
  // Away from the border, where the estimate is half as much.
  scene.Cropping = { { -1e9, 1e9, -1e9, 1e9, 1.0, 3.0 } };
  const double factor = 8.0 * 3.5 / 3.0 / 20.0;
  CHECK(ComputeMiddle(scene).Color[3] == Approx(1.0 - std::pow(0.7, 2.0 * factor)).margin(1e-5));
}
