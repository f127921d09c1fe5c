#include "ScalarField.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::reference
{
namespace
{
/// Returns how many there were.
std::size_t ReplaceNotFinite(std::vector<double>& values)
{
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -smallest;
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
  }
  if (smallest > largest)
  {
    smallest = largest = 0.0;
  }
  std::size_t replaced = 0;
  for (double& value : values)
  {
    if (!std::isfinite(value))
    {
      value = value > 0.0 ? largest : smallest;
      ++replaced;
    }
  }
  return replaced;
}

/// A voxel's 26 neighbours and itself, f(i, j, k) with each index from -1 to 1.
class Neighbourhood
{
public:
  Neighbourhood(const ScalarField& field, const VoxelIndex& voxel)
    : Field(field)
    , Voxel(voxel)
  {
  }

  double At(const VoxelIndex& offset) const
  {
    return this->Field.AtNearest(
      this->Voxel[0] + offset[0], this->Voxel[1] + offset[1], this->Voxel[2] + offset[2]);
  }

  /// Of the plane `side` before (-1), through (0) or behind (1) the voxel along an axis, with the
  /// weights 1 3 1, 3 6 3, 1 3 1 across it, over their sum.
  double GetSobelMean(int axis, int side) const
  {
    double sum = 0.0;
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        VoxelIndex offset;
        offset[axis] = side;
        offset[(axis + 1) % 3] = i;
        offset[(axis + 2) % 3] = j;
        const int distance = std::abs(i) + std::abs(j);
        sum += (distance == 0 ? 6.0 : distance == 1 ? 3.0 : 1.0) * this->At(offset);
      }
    }
    return sum / 22.0;
  }

  double GetBeside(int axis, int side) const
  {
    VoxelIndex offset{};
    offset[axis] = side;
    return this->At(offset);
  }

private:
  const ScalarField& Field;
  const VoxelIndex& Voxel;
};

double EstimateDerivative(const Neighbourhood& f, int axis, GradientEstimator estimator)
{
  switch (estimator)
  {
    case GradientEstimator::ForwardDifferences:
      return f.GetBeside(axis, 1) - f.GetBeside(axis, 0);
    case GradientEstimator::BackwardDifferences:
      return f.GetBeside(axis, 0) - f.GetBeside(axis, -1);
    case GradientEstimator::Sobel:
      return 0.5 * (f.GetSobelMean(axis, 1) - f.GetSobelMean(axis, -1));
    default:
      return 0.5 * (f.GetBeside(axis, 1) - f.GetBeside(axis, -1));
  }
}
}

//------------------------------------------------------------------------------
ScalarField::ScalarField(vtkImageData* volume)
{
  volume->GetDimensions(this->Dimensions.data());
  this->Rows = this->Dimensions[0];
  this->Slices = this->Rows * this->Dimensions[1];
  this->Next = { this->Dimensions[0] > 1 ? 1 : 0, this->Dimensions[1] > 1 ? this->Rows : 0,
    this->Dimensions[2] > 1 ? this->Slices : 0 };
  vtkDataArray* scalars = volume->GetPointData()->GetScalars();
  this->Values.resize(scalars->GetNumberOfTuples());
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    this->Values[i] = scalars->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  this->Replaced = ReplaceNotFinite(this->Values);
}

//------------------------------------------------------------------------------
double ScalarField::AtNearest(int i, int j, int k) const
{
  return this->At({ std::clamp(i, 0, this->Dimensions[0] - 1),
    std::clamp(j, 0, this->Dimensions[1] - 1), std::clamp(k, 0, this->Dimensions[2] - 1) });
}

//------------------------------------------------------------------------------
vtkVector3d ScalarField::GetGradient(const VoxelIndex& voxel, GradientEstimator estimator) const
{
  const Neighbourhood neighbourhood(*this, voxel);
  return { EstimateDerivative(neighbourhood, 0, estimator),
    EstimateDerivative(neighbourhood, 1, estimator),
    EstimateDerivative(neighbourhood, 2, estimator) };
}

//------------------------------------------------------------------------------
std::array<CellCorners, 3> ScalarField::GetGradients(
  const VoxelIndex& cell, GradientEstimator estimator) const
{
  std::array<CellCorners, 3> gradients;
  for (int corner = 0; corner < 8; ++corner)
  {
    VoxelIndex voxel;
    for (int axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = std::min(cell[axis] + ((corner >> axis) & 1), this->Dimensions[axis] - 1);
    }
    const vtkVector3d gradient = this->GetGradient(voxel, estimator);
    for (int axis = 0; axis < 3; ++axis)
    {
      gradients[axis][corner] = gradient[axis];
    }
  }
  return gradients;
}

}
