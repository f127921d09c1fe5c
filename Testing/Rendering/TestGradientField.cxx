#include "Catch.h"
#include "GradientField.h"
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

constexpr GradientEstimator Estimators[] = { GradientEstimator::CentralDifferences,
  GradientEstimator::ForwardDifferences, GradientEstimator::BackwardDifferences,
  GradientEstimator::Sobel };

// Whole slopes, so that every sum of these is exact.
constexpr Point Slope = { 3.0, -5.0, 7.0 };

std::vector<float> GetGradients(
  const Index& dimensions, const ScalarField& field, GradientEstimator estimator)
{
  VolumeGrid grid;
  grid.dimensions = dimensions;
  grid.scalarType = VTK_DOUBLE;
  const auto image = SampleField(grid, field);
  return ComputeGradientField(image->GetPointData()->GetScalars(), dimensions, estimator);
}

double GetLinear(const Point& p)
{
  return Slope[0] * p[0] + Slope[1] * p[1] + Slope[2] * p[2] - 11.0;
}

// What share of a linear field's slope an estimator finds at an index along its axis.
double GetShare(GradientEstimator estimator, int index, int size)
{
  const bool first = index == 0;
  const bool last = index == size - 1;
  switch (estimator)
  {
    case GradientEstimator::ForwardDifferences:
      return last ? 0.0 : 1.0;
    case GradientEstimator::BackwardDifferences:
      return first ? 0.0 : 1.0;
    default:
      return 1.0 - 0.5 * first - 0.5 * last;
  }
}

// A Sobel difference written out: all 18 values with their weights.
double GetSobel(
  const std::vector<double>& values, const Index& dimensions, const Index& voxel, int axis)
{
  double sum = 0.0;
  for (int across = 0; across < 9; ++across)
  {
    const int u = across % 3 - 1;
    const int v = across / 3 - 1;
    for (const int side : { -1, 1 })
    {
      Index at = voxel;
      at[axis] += side;
      at[(axis + 1) % 3] += u;
      at[(axis + 2) % 3] += v;
      for (int i = 0; i < 3; ++i)
      {
        at[i] = std::clamp(at[i], 0, dimensions[i] - 1);
      }
      const int weight = u == 0 && v == 0 ? 6 : (u == 0 || v == 0 ? 3 : 1);
      sum += side * weight * values[at[0] + dimensions[0] * (at[1] + dimensions[1] * at[2])];
    }
  }
  return sum / 44.0;
}
}

TEST_CASE("Every estimator is exact on a linear field, and clamps at its border")
{
  const Index size = { 5, 4, 6 };
  for (const GradientEstimator estimator : Estimators)
  {
    const std::vector<float> gradients = GetGradients(size, GetLinear, estimator);
    REQUIRE(gradients.size() == 3 * 5 * 4 * 6);
    auto gradient = gradients.begin();
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          INFO("estimator " << static_cast<int>(estimator) << " at " << x << " " << y << " " << z);
          CHECK(*gradient++ == Slope[0] * GetShare(estimator, x, size[0]));
          CHECK(*gradient++ == Slope[1] * GetShare(estimator, y, size[1]));
          CHECK(*gradient++ == Slope[2] * GetShare(estimator, z, size[2]));
        }
      }
    }
  }
}

TEST_CASE("Nothing changes along an axis of a single voxel")
{
  for (const GradientEstimator estimator : Estimators)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Index thin = { 4, 4, 4 };
      thin[axis] = 1;
      const std::vector<float> gradients = GetGradients(thin, GetLinear, estimator);
      for (size_t i = 0; i < gradients.size(); i += 3)
      {
        CHECK(gradients[i + axis] == 0.0f);
      }
      // Only the last voxels have no forward, only the first no backward difference.
      const int other = (axis + 1) % 3;
      const size_t first =
        estimator == GradientEstimator::BackwardDifferences ? gradients.size() - 3 : 0;
      CHECK(gradients[first + other] == Slope[other] * GetShare(estimator, first == 0 ? 0 : 3, 4));
    }
    CHECK(GetGradients({ 1, 1, 1 }, GetLinear, estimator) == std::vector<float>(3, 0.0f));
  }
}

TEST_CASE("Sobel weighs all 18 neighbours, at the border too")
{
  const Index size = { 6, 5, 4 };
  std::mt19937 random(1);
  std::vector<double> values;
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    values.push_back(random() % 4096);
  }
  const auto scalars = MakeArray(VTK_UNSIGNED_SHORT, values);
  const auto gradients = ComputeGradientField(scalars, size, GradientEstimator::Sobel);
  for (int voxel = 0; voxel < static_cast<int>(values.size()); ++voxel)
  {
    const Index at = { voxel % size[0], voxel / size[0] % size[1], voxel / size[0] / size[1] };
    for (int axis = 0; axis < 3; ++axis)
    {
      INFO("voxel " << voxel << " axis " << axis);
      // Sums of whole numbers are exact, and so is one division.
      CHECK(gradients[3 * voxel + axis] == static_cast<float>(GetSobel(values, size, at, axis)));
    }
  }
}
