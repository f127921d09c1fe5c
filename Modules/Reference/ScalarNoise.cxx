#include "ScalarNoise.h"

#include "ScalarField.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra::reference
{
namespace
{
// Of a normal distribution's absolute values, in standard deviations.
constexpr double MedianOfNormal = 0.6745;

void AppendSecondDifferences(const ScalarField& field, int axis, std::vector<double>& differences)
{
  const std::vector<double>& values = field.GetValues();
  const double smallest = *std::min_element(values.begin(), values.end());
  const VoxelIndex& dimensions = field.GetDimensions();
  VoxelIndex voxel;
  for (voxel[2] = 0; voxel[2] < dimensions[2]; ++voxel[2])
  {
    for (voxel[1] = 0; voxel[1] < dimensions[1]; ++voxel[1])
    {
      for (voxel[0] = 0; voxel[0] < dimensions[0]; ++voxel[0])
      {
        if (voxel[axis] == 0 || voxel[axis] == dimensions[axis] - 1)
        {
          continue;
        }
        VoxelIndex before = voxel;
        VoxelIndex after = voxel;
        --before[axis];
        ++after[axis];
        const double a = field.At(before);
        const double b = field.At(voxel);
        const double c = field.At(after);
        if (std::min({ a, b, c }) > smallest)
        {
          differences.push_back(std::abs(a - 2.0 * b + c));
        }
      }
    }
  }
}

double EstimateNoise(const ScalarField& field)
{
  std::vector<double> differences;
  for (int axis = 0; axis < 3; ++axis)
  {
    AppendSecondDifferences(field, axis, differences);
  }
  if (differences.empty())
  {
    return 0.0;
  }
  const auto middle = differences.begin() + differences.size() / 2;
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle / (MedianOfNormal * std::sqrt(6.0));
}

/// The root of the sum of the squared weights of one component.
double GetWeight(GradientEstimator estimator)
{
  switch (estimator)
  {
    case GradientEstimator::ForwardDifferences:
    case GradientEstimator::BackwardDifferences:
      return std::sqrt(2.0);
    case GradientEstimator::Sobel:
      // Twice one weight of 6, four of 3, four of 1.
      return std::sqrt(2.0 * (36.0 + 4.0 * 9.0 + 4.0)) / 44.0;
    default:
      return std::sqrt(0.5);
  }
}
}

//------------------------------------------------------------------------------
double GetGradientNoise(
  const ScalarField& field, const vtkVector3d& spacing, GradientEstimator estimator)
{
  double sumOfSquares = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (field.GetDimensions()[axis] > 1)
    {
      sumOfSquares += 1.0 / (spacing[axis] * spacing[axis]);
    }
  }
  return EstimateNoise(field) * GetWeight(estimator) * std::sqrt(sumOfSquares);
}

}
