#include "Catch.h"
#include "ShadowedVolume.h"

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Extinction = 0.15;
constexpr double Rounding = 2e-6;

/// Gradient opacity that rises from 0 at a magnitude of 0 to 1 at one of 100.
void SetGradientOpacity(ShadowedVolume& scene)
{
  scene.SetExtinction(Extinction);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(100.0, 1.0);
  scene.Property->SetGradientOpacity(opacity);
}

/// z squared in voxels.
vtkSmartPointer<vtkImageData> MakeParabola(int size)
{
  VolumeGrid grid;
  grid.dimensions = { 4, 4, size };
  grid.scalarType = VTK_FLOAT;
  return SampleField(grid, [](const Point& point) { return point[2] * point[2]; });
}
}

// A slope of 2 along x and 3 along y is 2 and 3 scalar units per length; the mean spacing is 7/6.
TEST_CASE("Gradient opacity takes scalar units per mean voxel, in the volume's own lengths")
{
  VolumeGrid grid;
  grid.dimensions = { 12, 12, 12 };
  grid.spacing = { 1.0, 0.5, 2.0 };
  grid.scalarType = VTK_FLOAT;
  ShadowedVolume scene(
    SampleField(grid, [](const Point& point) { return 2.0 * point[0] + 30.0 * point[1]; }));
  SetGradientOpacity(scene);
  // Far from the sides, where differences across the border are halved.
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  const double extinction = Extinction * std::hypot(2.0, 30.0) * (3.5 / 3.0) / 100.0;
  CHECK(GetLargestError(scene,
          [&](const Point& point)
          {
            const bool border =
              point[0] < 0.5 || point[0] > 10.5 || point[1] < 0.2 || point[1] > 5.3;
            const double halved = Extinction * (3.5 / 3.0) / 100.0 *
              std::hypot(point[0] < 0.5 || point[0] > 10.5 ? 1.0 : 2.0,
                point[1] < 0.2 || point[1] > 5.3 ? 15.0 : 30.0);
            return std::exp(-(border ? halved : extinction) * (22.0 - point[2]));
          }) < Rounding);
}

// Linear in the volume's own coordinates, whatever the directions of its voxels.
TEST_CASE(
  "Gradient opacity takes the gradient in the volume's own lengths under a sheared direction")
{
  const double direction[9] = { 1, 0, 0.3, 0, 1, -0.4, 0, 0, 0.9 };
  VolumeGrid grid;
  grid.dimensions = { 9, 9, 9 };
  grid.scalarType = VTK_FLOAT;
  const Point slopes = { 12.0, -20.0, 31.0 };
  const auto volume = SampleField(grid,
    [&](const Point& voxel)
    {
      return slopes[0] * (voxel[0] + 0.3 * voxel[2]) + slopes[1] * (voxel[1] - 0.4 * voxel[2]) +
        slopes[2] * 0.9 * voxel[2];
    });
  volume->SetDirectionMatrix(direction);
  ShadowedVolume scene(volume);
  SetGradientOpacity(scene);
  scene.AddPoint({ 4.0 + 0.3 * 4, 4.0 - 0.4 * 4, 0.9 * 4 });
  const std::vector<float> visibility = scene.Compute();
  const double depth = Extinction * Length(slopes) / 100.0 * Length({ 0.6, -0.8, 1.8 });
  CHECK(visibility[4 + 9 * (4 + 9 * 2)] == Approx(std::exp(-depth)).margin(Rounding));
}

TEST_CASE("Gradients beyond single precision count as the largest")
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 3 };
  grid.scalarType = VTK_DOUBLE;
  ShadowedVolume scene(SampleField(grid, [](const Point& point) { return 1e60 * point[2]; }));
  SetGradientOpacity(scene);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  CHECK(GetLargestError(scene,
          [](const Point& point) { return std::exp(-Extinction * (2.0 - point[2])); }) < Rounding);
}

TEST_CASE("There is no gradient along an axis of a single voxel")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 1, 1 };
  grid.scalarType = VTK_FLOAT;
  ShadowedVolume scene(SampleField(grid, [](const Point&) { return 1e7 / 3.0; }));
  SetGradientOpacity(scene);
  // Opaque as soon as there is any gradient at all.
  scene.Property->GetGradientOpacity()->RemoveAllPoints();
  scene.Property->GetGradientOpacity()->AddPoint(0.0, 0.0);
  scene.Property->GetGradientOpacity()->AddPoint(1e-30, 1.0);
  scene.Filter->SetGradientEstimator(GENERATE(vtkVolumeVisibilityFilter::CentralDifferences,
    vtkVolumeVisibilityFilter::ForwardDifferences, vtkVolumeVisibilityFilter::Sobel));
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  CHECK(GetLargestError(scene, [](const Point&) { return 1.0; }) == 0.0);
}

TEST_CASE("A uniform volume is transparent where no gradient is")
{
  VolumeGrid grid;
  ShadowedVolume scene(MakeUniform(grid));
  SetGradientOpacity(scene);
  scene.AddDirectional({ 0.3, 0.2, 1.0 });
  CHECK(GetLargestError(scene, [](const Point&) { return 1.0; }) == 0.0);
  scene.Property->SetDisableGradientOpacity(1);
  CHECK(GetLargestError(scene,
          [&](const Point& point) {
            return std::exp(-Extinction * GetExit(grid, point, { 0.3, 0.2, 1.0 }));
          }) < Rounding);
}

// Differences of z squared: 2z centrally, 2z + 1 and 2z - 1 to either side; interpolated in between
// they stay straight lines.
TEST_CASE("Each estimator takes its own neighbours")
{
  const auto [estimator, shift] =
    GENERATE(std::make_pair(vtkVolumeVisibilityFilter::CentralDifferences, 0.0),
      std::make_pair(vtkVolumeVisibilityFilter::ForwardDifferences, 1.0),
      std::make_pair(vtkVolumeVisibilityFilter::BackwardDifferences, -1.0),
      std::make_pair(vtkVolumeVisibilityFilter::Sobel, 0.0));
  ShadowedVolume scene(MakeParabola(20));
  SetGradientOpacity(scene);
  scene.Filter->SetGradientEstimator(estimator);
  // From the points at z = 17 down to the light at z = 2.
  scene.AddPoint({ 1.5, 1.5, 2.0 });
  const std::vector<float> visibility = scene.Compute();
  const double depth = Extinction * (17.0 * 17.0 - 2.0 * 2.0 + 15.0 * shift) / 100.0;
  const double oblique = std::hypot(15.0, 0.5, 0.5) / 15.0;
  CHECK(visibility[1 + 4 * (1 + 4 * 17)] == Approx(std::exp(-depth * oblique)).margin(1e-5));
}

// A single voxel that is not 0 shows its neighbours the weights themselves. A ray of a thousandth
// of a voxel sees the gradient of the voxel that it begins at.
TEST_CASE("Sobel's differences weigh the neighbours across by 1, 3 and 6")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 5 };
  grid.scalarType = VTK_FLOAT;
  ShadowedVolume scene(SampleField(grid,
    [](const Point& point) {
      return Length(point - Point{ 2.0, 2.0, 2.0 }) < 0.1 ? 440.0 : 0.0;
    }));
  SetGradientOpacity(scene);
  scene.Filter->SetGradientEstimator(vtkVolumeVisibilityFilter::Sobel);
  scene.Property->SetScalarOpacityUnitDistance(1e-3);
  scene.SetExtinction(1000.0);
  const auto light = scene.AddPoint({ 0.0, 0.0, 0.0 });
  const auto getMagnitude = [&](const Point& at)
  {
    light->SetPosition(at[0] + 1e-3, at[1], at[2]);
    const std::vector<float> visibility = scene.Compute();
    return -100.0 * std::log(visibility[static_cast<int>(at[0] + 5 * (at[1] + 5 * at[2]))]);
  };
  CHECK(getMagnitude({ 2.0, 2.0, 1.0 }) == Approx(60.0).epsilon(1e-2));
  CHECK(getMagnitude({ 2.0, 1.0, 1.0 }) == Approx(std::hypot(30.0, 30.0)).epsilon(1e-2));
  CHECK(getMagnitude({ 1.0, 1.0, 1.0 }) == Approx(10.0 * std::sqrt(3.0)).epsilon(1e-2));
}
