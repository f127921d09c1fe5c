#include "GradientNoise.h"

#include "GradientField.h"
#include "ScalarRange.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace penumbra
{
namespace
{
constexpr vtkIdType MostDifferences = 2000000;

/// From voxel to voxel. Without a common divisor with a slice it meets all places of one.
vtkIdType ChooseStride(const std::array<int, 3>& dimensions)
{
  const vtkIdType slice = static_cast<vtkIdType>(dimensions[0]) * dimensions[1];
  vtkIdType stride = 1 + 3 * slice * dimensions[2] / MostDifferences;
  while (std::gcd(stride, slice) != 1)
  {
    ++stride;
  }
  return stride;
}

std::vector<double> GetSecondDifferences(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions)
{
  const ScalarRange range = ComputeScalarRange(scalars);
  const auto getValue = [&](vtkIdType voxel)
  {
    const double value = scalars->GetComponent(voxel, 0);
    // NaN is not above anything.
    return value > range.Low ? std::min(value, range.High) : range.Low;
  };
  const vtkIdType stride = ChooseStride(dimensions);
  std::vector<double> differences;
  for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); voxel += stride)
  {
    const double value = getValue(voxel);
    vtkIdType step = 1;
    for (const int size : dimensions)
    {
      const vtkIdType index = voxel / step % size;
      if (index > 0 && index < size - 1)
      {
        const double behind = getValue(voxel - step);
        const double ahead = getValue(voxel + step);
        if (std::min({ behind, value, ahead }) > range.Low)
        {
          differences.push_back(std::abs(behind - 2.0 * value + ahead));
        }
      }
      step *= size;
    }
  }
  return differences;
}
}

//------------------------------------------------------------------------------
double EstimateNoise(vtkDataArray* scalars, const std::array<int, 3>& dimensions)
{
  std::vector<double> differences = GetSecondDifferences(scalars, dimensions);
  if (differences.empty())
  {
    return 0.0;
  }
  const auto median = differences.begin() + differences.size() / 2;
  std::nth_element(differences.begin(), median, differences.end());
  constexpr double medianOfNormal = 0.6744897501960817;
  return *median / (medianOfNormal * std::sqrt(6.0));
}

//------------------------------------------------------------------------------
double GradientNoise(double noise, GradientEstimator estimator)
{
  double squares = 0.0;
  double sum = 0.0;
  switch (estimator)
  {
    case GradientEstimator::CentralDifferences:
      return noise * std::sqrt(2.0) / 2.0;
    case GradientEstimator::ForwardDifferences:
    case GradientEstimator::BackwardDifferences:
      return noise * std::sqrt(2.0);
    case GradientEstimator::Sobel:
      for (const auto& line : SobelWeights)
      {
        for (const int weight : line)
        {
          sum += weight;
          squares += weight * weight;
        }
      }
      break;
  }
  return noise * std::sqrt(2.0 * squares) / (2.0 * sum);
}

}
