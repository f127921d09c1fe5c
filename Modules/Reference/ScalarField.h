/**
 * @file    ScalarField.h
 * @brief   a volume's voxels in double precision, and estimates of their gradient
 *
 * NaN and -infinity count as the smallest finite value, +infinity as the largest. Beyond the
 * outermost voxels the field goes on with their values.
 */

#ifndef ScalarField_h
#define ScalarField_h

#include "CellPath.h"
#include "LightingRequirements.h" // For GradientEstimator

#include "vtkVector.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkImageData;

namespace penumbra::reference
{

using VoxelIndex = std::array<int, 3>;

class ScalarField
{
public:
  explicit ScalarField(vtkImageData* volume);

  const VoxelIndex& GetDimensions() const { return this->Dimensions; }
  /// How many voxels were NaN or infinite.
  std::size_t GetNumberOfReplaced() const { return this->Replaced; }
  const std::vector<double>& GetValues() const { return this->Values; }

  double At(const VoxelIndex& voxel) const
  {
    return this->Values[voxel[0] + this->Rows * voxel[1] + this->Slices * voxel[2]];
  }
  /// The nearest voxel where there is none.
  double AtNearest(int i, int j, int k) const;

  /// The cell from this voxel to the next along each axis that has more than one.
  CellCorners GetCorners(const VoxelIndex& cell) const
  {
    const double* first =
      this->Values.data() + cell[0] + this->Rows * cell[1] + this->Slices * cell[2];
    const std::ptrdiff_t x = this->Next[0];
    const std::ptrdiff_t y = this->Next[1];
    const std::ptrdiff_t z = this->Next[2];
    return { first[0], first[x], first[y], first[x + y], first[z], first[x + z], first[y + z],
      first[x + y + z] };
  }

  /**
   * The estimated gradient at a voxel, in scalar units per voxel. Within cells it is interpolated:
   * as its estimate is a sum of the field's values at whole voxels' distance, its interpolation
   * is what the interpolated field has.
   */
  vtkVector3d GetGradient(const VoxelIndex& voxel, GradientEstimator estimator) const;

  /// Its components at a cell's corners.
  std::array<CellCorners, 3> GetGradients(
    const VoxelIndex& cell, GradientEstimator estimator) const;

private:
  VoxelIndex Dimensions{};
  std::ptrdiff_t Rows = 0;
  std::ptrdiff_t Slices = 0;
  /// Distance in memory to the next voxel along each axis; 0 where there is but one.
  std::array<std::ptrdiff_t, 3> Next{};
  std::size_t Replaced = 0;
  std::vector<double> Values;
};

}

#endif
