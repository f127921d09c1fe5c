#include "Catch.h"
#include "GradientNoise.h"
#include "MakeArray.h"
#include "SyntheticVolumes.h"

#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace penumbra;

namespace
{
constexpr double Sigma = 12.0;

VolumeGrid MakeGrid(const std::array<int, 3>& dimensions, int scalarType = VTK_DOUBLE)
{
  VolumeGrid grid;
  grid.dimensions = dimensions;
  grid.scalarType = scalarType;
  return grid;
}

vtkSmartPointer<vtkImageData> MakeNoisyBall(const VolumeGrid& grid)
{
  const auto ball =
    MakeBall(grid, 0.6 * grid.InnerRadius(), 0.5 * grid.InnerRadius(), { 400.0, 0.0 });
  vtkDataArray* scalars = ball->GetPointData()->GetScalars();
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0.0, Sigma);
  for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); ++voxel)
  {
    const double value = scalars->GetTuple1(voxel) + normal(random);
    scalars->SetTuple1(voxel, grid.scalarType == VTK_SHORT ? std::round(value) : value);
  }
  return ball;
}

double Estimate(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  return EstimateNoise(
    image->GetPointData()->GetScalars(), { dimensions[0], dimensions[1], dimensions[2] });
}

// The image in the middle of one that is wider by that many voxels of that value on every side.
vtkSmartPointer<vtkImageData> Surround(vtkImageData* image, int margin, double value)
{
  const std::array<double, 3> last = { image->GetDimensions()[0] - 1.0,
    image->GetDimensions()[1] - 1.0, image->GetDimensions()[2] - 1.0 };
  VolumeGrid grid = MakeGrid({ 0, 0, 0 }, image->GetScalarType());
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.dimensions[axis] = image->GetDimensions()[axis] + 2 * margin;
  }
  return SampleField(grid,
    [&](const Point& p)
    {
      int at[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        if (p[axis] < margin || p[axis] > margin + last[axis])
        {
          return value;
        }
        at[axis] = static_cast<int>(p[axis]) - margin;
      }
      return image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
    });
}
}

TEST_CASE("The noise of a smooth ball is found within 5 %")
{
  for (const int size : { 48, 100 })
  {
    // Of the larger volume every third voxel counts.
    const double noise = Estimate(MakeNoisyBall(MakeGrid({ size, size, size })));
    INFO(size << " voxels wide: " << noise);
    CHECK(noise == Approx(Sigma).epsilon(0.05));
  }
  const double noise = Estimate(MakeNoisyBall(MakeGrid({ 60, 60, 60 }, VTK_SHORT)));
  // Whole numbers bring multiples of .6, and noise of 1/12 of their own.
  CHECK(noise == Approx(Sigma).epsilon(0.05));
}

TEST_CASE("A smooth volume has no noise")
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const VolumeGrid grid = MakeGrid({ 33, 33, 33 });
    CHECK(Estimate(MakeRamp(grid, axis, { 64.0, 0.0 })) == 0.0);
  }
  const auto tilted = SampleField(MakeGrid({ 20, 30, 10 }, VTK_SHORT),
    [](const Point& p) { return 7.0 * p[0] - 3.0 * p[1] + p[2]; });
  CHECK(Estimate(tilted) == 0.0);
}

TEST_CASE("Edges are not noise")
{
  // Four in ten differences cross an edge.
  const auto bars = SampleField(MakeGrid({ 40, 40, 40 }),
    [](const Point& p) { return std::fmod(p[0], 5.0) < 2.0 ? 100.0 : 700.0 + p[1]; });
  CHECK(Estimate(bars) == 0.0);
}

TEST_CASE("Background does not count")
{
  const auto ball = MakeNoisyBall(MakeGrid({ 30, 30, 30 }));
  const double noise = Estimate(ball);
  for (const double background : { -1000.0, -1e6 })
  {
    // Without background the ball's own smallest voxel does not count: 9 of 75,600 differences.
    CHECK(Estimate(Surround(ball, 12, background)) == Approx(noise).epsilon(1e-3));
  }
  const auto holes = Surround(ball, 12, std::nan(""));
  CHECK(Estimate(holes) == Approx(noise).epsilon(1e-12));
}

TEST_CASE("Where there are no three voxels in a row nothing is known")
{
  CHECK(EstimateNoise(MakeArray(VTK_FLOAT, { 1.0, 5.0, 2.0, 9.0 }), { 2, 2, 1 }) == 0.0);
  CHECK(EstimateNoise(MakeArray(VTK_FLOAT, std::vector<double>(27, 4.0)), { 3, 3, 3 }) == 0.0);
  // One difference, |2 - 12 + 3|, beside a column of background.
  const auto scalars = MakeArray(VTK_SHORT, { 2.0, 0.0, 6.0, 0.0, 3.0, 0.0 });
  const double noise = 7.0 / (0.6744897501960817 * std::sqrt(6.0));
  CHECK(EstimateNoise(scalars, { 2, 3, 1 }) == Approx(noise).epsilon(1e-12)); // rounding
  CHECK(EstimateNoise(scalars, { 2, 1, 3 }) == Approx(noise).epsilon(1e-12));
}

TEST_CASE("Of a large volume all columns count")
{
  // 6.3 million differences: every fourth voxel would do, and meet the quiet columns only.
  const VolumeGrid grid = MakeGrid({ 128, 128, 128 });
  std::mt19937 random(13);
  std::normal_distribution<double> normal(0.0, Sigma);
  const auto image = SampleField(grid,
    [&](const Point& p) { return static_cast<int>(p[0]) % 4 == 0 ? 1e4 : 1e4 + normal(random); });
  CHECK(Estimate(image) > 0.5 * Sigma);
}
