#include "Catch.h"
#include "GradientField.h"
#include "GradientNoise.h"
#include "MakeArray.h"
#include "SyntheticVolumes.h"

#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace penumbra;

namespace
{
using Index = std::array<int, 3>;

constexpr Point Frequency = { 1.1, 0.9, 1.3 };
constexpr Point Phase = { 0.2, 0.5, 0.1 };

// The product of sines along the axes, or its derivative along one of them.
double GetWaves(const Point& p, int derivative)
{
  double product = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double angle = Frequency[axis] * p[axis] + Phase[axis];
    product *= axis == derivative ? Frequency[axis] * std::cos(angle) : std::sin(angle);
  }
  return product;
}

bool IsInside(const Index& voxel, const Index& size)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (voxel[axis] == 0 || voxel[axis] == size[axis] - 1)
    {
      return false;
    }
  }
  return true;
}

template <typename Use>
void ForEachInside(const Index& size, const Use& use)
{
  for (int voxel = 0; voxel < size[0] * size[1] * size[2]; ++voxel)
  {
    const Index at = { voxel % size[0], voxel / size[0] % size[1], voxel / size[0] / size[1] };
    if (IsInside(at, size))
    {
      use(voxel, at);
    }
  }
}

// The largest error of the derivative of waves over a cube 3.2 wide.
double GetLargestError(GradientEstimator estimator, int intervals)
{
  const double spacing = 3.2 / intervals;
  VolumeGrid grid;
  grid.dimensions = { intervals + 1, intervals + 1, intervals + 1 };
  grid.spacing = { spacing, spacing, spacing };
  grid.scalarType = VTK_DOUBLE;
  const auto image = SampleField(grid, [](const Point& p) { return GetWaves(p, -1); });
  const auto gradients =
    ComputeGradientField(image->GetPointData()->GetScalars(), grid.dimensions, estimator);
  double largest = 0.0;
  ForEachInside(grid.dimensions,
    [&](int voxel, const Index& at)
    {
      const Point p = { spacing * at[0], spacing * at[1], spacing * at[2] };
      for (int axis = 0; axis < 3; ++axis)
      {
        const double derivative = gradients[3 * voxel + axis] / spacing;
        largest = std::max(largest, std::abs(derivative - GetWaves(p, axis)));
      }
    });
  return largest;
}

double GetOrder(GradientEstimator estimator)
{
  return std::log2(GetLargestError(estimator, 32) / GetLargestError(estimator, 64));
}

// Standard deviation of the components of the gradient of white noise of standard deviation 1.
double GetDeviation(GradientEstimator estimator)
{
  const Index size = { 64, 64, 64 };
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> values(size[0] * size[1] * size[2]);
  std::generate(values.begin(), values.end(), [&] { return normal(random); });
  const auto gradients = ComputeGradientField(MakeArray(VTK_DOUBLE, values), size, estimator);
  double squares = 0.0;
  int count = 0;
  ForEachInside(size,
    [&](int voxel, const Index&)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        squares += gradients[3 * voxel + axis] * gradients[3 * voxel + axis];
        ++count;
      }
    });
  return std::sqrt(squares / count);
}
}

TEST_CASE("Central differences and Sobel are of second order, one-sided differences of first")
{
  // The next order's share of the error at these spacings is below 5 %.
  const double central = GetOrder(GradientEstimator::CentralDifferences);
  const double forward = GetOrder(GradientEstimator::ForwardDifferences);
  const double backward = GetOrder(GradientEstimator::BackwardDifferences);
  const double sobel = GetOrder(GradientEstimator::Sobel);
  INFO("central " << central << " forward " << forward << " backward " << backward << " Sobel "
                  << sobel);
  CHECK((central > 1.9 && central < 2.1));
  CHECK((sobel > 1.9 && sobel < 2.1));
  CHECK((forward > 0.9 && forward < 1.1));
  CHECK((backward > 0.9 && backward < 1.1));
}

TEST_CASE("The noise of a gradient is what its weights say")
{
  for (const GradientEstimator estimator :
    { GradientEstimator::CentralDifferences, GradientEstimator::ForwardDifferences,
      GradientEstimator::BackwardDifferences, GradientEstimator::Sobel })
  {
    INFO("estimator " << static_cast<int>(estimator));
    // 6 standard errors of Sobel's, whose 715,000 components are as good as 180,000 independent.
    CHECK(GetDeviation(estimator) == Approx(GradientNoise(1.0, estimator)).epsilon(0.01));
  }
}

TEST_CASE("Sobel leaves .396 of the noise that central differences do")
{
  const double ratio =
    GetDeviation(GradientEstimator::Sobel) / GetDeviation(GradientEstimator::CentralDifferences);
  INFO("ratio " << ratio);
  // sqrt(76) / 22, from the sums of the squared weights and of the weights; tolerance as above.
  CHECK(ratio == Approx(0.39626).epsilon(0.01));
}

TEST_CASE("The noise of a gradient in closed form")
{
  // Rounding.
  const double tolerance = 1e-12;
  const auto closeTo = [&](double value) { return Approx(value).epsilon(tolerance); };
  CHECK(GradientNoise(3.0, GradientEstimator::CentralDifferences) == closeTo(3.0 / std::sqrt(2.0)));
  CHECK(GradientNoise(3.0, GradientEstimator::ForwardDifferences) == closeTo(3.0 * std::sqrt(2.0)));
  CHECK(
    GradientNoise(3.0, GradientEstimator::BackwardDifferences) == closeTo(3.0 * std::sqrt(2.0)));
  CHECK(GradientNoise(3.0, GradientEstimator::Sobel) == closeTo(3.0 * std::sqrt(152.0) / 44.0));
  CHECK(GradientNoise(0.0, GradientEstimator::Sobel) == 0.0);
}
