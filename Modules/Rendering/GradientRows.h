/**
 * @file    GradientRows.h
 * @brief   the gradients at a volume's voxels, estimated row by row
 *
 * Sums are in double precision and voxel by voxel, so that threads never change them.
 * GradientField.h says what a gradient is.
 */

#ifndef GradientRows_h
#define GradientRows_h

#include "LightingRequirements.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

class vtkDataArray;

namespace penumbra
{

/// Values of voxels along x.
using Row = std::vector<double>;
/// Writes the scalars of a row, all finite.
using RowReader = std::function<void(vtkIdType row, double* values)>;

RowReader MakeRowReader(vtkDataArray* scalars, int length);

/// The gradients of one row of voxels after another.
class RowGradients
{
public:
  RowGradients(RowReader reader, const std::array<int, 3>& dimensions, GradientEstimator estimator);
  void Compute(int y, int z);

  std::array<Row, 3> Components;

private:
  void Read(int y, int z);
  void SubtractNeighbours(int ahead, int behind, double divisor);
  void SubtractPlanes();
  void WeighAlongX(Row& sum, const Row& smoothed, const Row& middle) const;

  RowReader Reader;
  std::array<int, 3> Dimensions;
  GradientEstimator Estimator;
  /// Rows[y][z]: 0 is behind the row, 1 at it, 2 ahead. Each has one more voxel at both ends.
  std::array<std::array<Row, 3>, 3> Rows;
  std::array<Row, 3> SmoothedAlongZ;
  Row SmoothedAlongY;
  Row Across;
  Row Behind;
  Row Ahead;
};

/// Calls use(row, z, components) for every row of voxels, those of one slice in their order.
template <typename Use>
void ForEachRow(vtkDataArray* scalars, const std::array<int, 3>& dimensions,
  GradientEstimator estimator, const Use& use)
{
  const RowReader reader = MakeRowReader(scalars, dimensions[0]);
  vtkSMPTools::For(0, dimensions[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      RowGradients gradients(reader, dimensions, estimator);
      for (vtkIdType z = begin; z < end; ++z)
      {
        for (int y = 0; y < dimensions[1]; ++y)
        {
          gradients.Compute(y, static_cast<int>(z));
          use(y + z * dimensions[1], z, gradients.Components);
        }
      }
    });
}

}

#endif
