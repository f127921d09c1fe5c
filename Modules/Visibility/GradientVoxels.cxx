#include "GradientVoxels.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace penumbra
{
namespace
{
// Nearly the largest float.
constexpr double Steepest = 1e38;

struct Neighbour
{
  std::array<int, 3> Offset;
  double Weight;
};

// What of the neighbours makes up the derivative along an axis.
using Stencil = std::vector<Neighbour>;

Neighbour MakeNeighbour(int axis, int along, double weight)
{
  Neighbour neighbour{ { 0, 0, 0 }, weight };
  neighbour.Offset[axis] = along;
  return neighbour;
}

// Weights 1-3-1, 3-6-3, 1-3-1 across on either side, over 44. Opposite neighbours follow each
// other, so that equal ones cancel exactly: there is no derivative along an axis of a single voxel.
Stencil MakeSobel(int axis)
{
  constexpr double weights[] = { 6.0, 3.0, 1.0 };
  Stencil stencil;
  for (int across = 0; across < 9; ++across)
  {
    for (const int along : { -1, 1 })
    {
      const int a = across % 3 - 1;
      const int b = across / 3 - 1;
      Neighbour neighbour =
        MakeNeighbour(axis, along, along * weights[std::abs(a) + std::abs(b)] / 44.0);
      neighbour.Offset[(axis + 1) % 3] = a;
      neighbour.Offset[(axis + 2) % 3] = b;
      stencil.push_back(neighbour);
    }
  }
  return stencil;
}

Stencil MakeStencil(GradientEstimator estimator, int axis)
{
  switch (estimator)
  {
    case GradientEstimator::ForwardDifferences:
      return { MakeNeighbour(axis, 1, 1.0), MakeNeighbour(axis, 0, -1.0) };
    case GradientEstimator::BackwardDifferences:
      return { MakeNeighbour(axis, 0, 1.0), MakeNeighbour(axis, -1, -1.0) };
    case GradientEstimator::Sobel:
      return MakeSobel(axis);
    default:
      return { MakeNeighbour(axis, 1, 0.5), MakeNeighbour(axis, -1, -0.5) };
  }
}

template <typename Scalar>
class Differences
{
public:
  Differences(
    const Scalar* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
    : Scalars(scalars)
    , Dimensions(dimensions)
    , Stencils{ MakeStencil(estimator, 0), MakeStencil(estimator, 1), MakeStencil(estimator, 2) }
  {
  }

  double GetDerivative(const std::array<int, 3>& voxel, int axis) const
  {
    double sum = 0.0;
    for (const Neighbour& neighbour : this->Stencils[axis])
    {
      sum += neighbour.Weight * this->GetValue(voxel, neighbour.Offset);
    }
    return sum;
  }

private:
  double GetValue(const std::array<int, 3>& voxel, const std::array<int, 3>& offset) const
  {
    vtkIdType index = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int at = std::clamp(voxel[axis] + offset[axis], 0, this->Dimensions[axis] - 1);
      index = index * this->Dimensions[axis] + at;
    }
    return static_cast<double>(this->Scalars[index]);
  }

  const Scalar* Scalars;
  std::array<int, 3> Dimensions;
  std::array<Stencil, 3> Stencils;
};

// Returns the square of the length.
template <typename Scalar>
double ComputeGradient(const Differences<Scalar>& differences, const std::array<int, 3>& voxel,
  const Matrix3& toOwn, float* gradient)
{
  Vector3 derivatives;
  for (int axis = 0; axis < 3; ++axis)
  {
    derivatives[axis] = differences.GetDerivative(voxel, axis);
  }
  double square = 0.0;
  for (int row = 0; row < 3; ++row)
  {
    const double component = toOwn[3 * row] * derivatives[0] + toOwn[3 * row + 1] * derivatives[1] +
      toOwn[3 * row + 2] * derivatives[2];
    gradient[row] = static_cast<float>(std::clamp(component, -Steepest, Steepest));
    square += static_cast<double>(gradient[row]) * gradient[row];
  }
  return square;
}

template <typename Scalar>
void ComputeGradients(const Scalar* scalars, const std::array<int, 3>& dimensions,
  const Matrix3& toOwn, GradientEstimator estimator, GradientVoxels& gradients)
{
  const Differences<Scalar> differences(scalars, dimensions, estimator);
  std::vector<double> largest(dimensions[2], 0.0);
  vtkSMPTools::For(0, dimensions[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      const vtkIdType slice = static_cast<vtkIdType>(dimensions[0]) * dimensions[1];
      for (vtkIdType voxel = begin * slice; voxel < end * slice; ++voxel)
      {
        const int z = static_cast<int>(voxel / slice);
        const std::array<int, 3> index = { static_cast<int>(voxel % dimensions[0]),
          static_cast<int>(voxel / dimensions[0] % dimensions[1]), z };
        const double square =
          ComputeGradient(differences, index, toOwn, &gradients.Values[3 * voxel]);
        largest[z] = std::max(largest[z], square);
      }
    });
  gradients.LargestMagnitude = std::sqrt(*std::max_element(largest.begin(), largest.end()));
}
}

//------------------------------------------------------------------------------
GradientVoxels ComputeGradientVoxels(
  vtkDataArray* scalars, const VolumeFrames& frames, GradientEstimator estimator)
{
  GradientVoxels gradients;
  gradients.Values.resize(3 * scalars->GetNumberOfTuples());
  Matrix3 toOwn = frames.GetGradientToOwn();
  for (double& element : toOwn)
  {
    element *= frames.MeanSpacing;
  }
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(ComputeGradients(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
      frames.Dimensions, toOwn, estimator, gradients));
  }
  return gradients;
}

}
