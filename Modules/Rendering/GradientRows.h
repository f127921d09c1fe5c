/**
 * @file    GradientRows.h
 * @brief   the differences at a volume's voxels that gradients are estimated by, row by row
 *
 * Sums are voxel by voxel, so that threads never change them: in double precision, or in integers
 * where scalars are whole and their sums no larger. A gradient is the difference over the divisor;
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

/// Values of voxels along x, double or int.
template <typename Value>
using Row = std::vector<Value>;
/// Writes the scalars of a row, all finite.
template <typename Value>
using RowReader = std::function<void(vtkIdType row, Value* values)>;

template <typename Value>
RowReader<Value> MakeRowReader(vtkDataArray* scalars, int length);

/// What the estimator's differences are multiples of gradients by.
double GetDifferenceDivisor(GradientEstimator estimator);

/// The differences of one row of voxels after another.
template <typename Value>
class RowDifferences
{
public:
  RowDifferences(
    RowReader<Value> reader, const std::array<int, 3>& dimensions, GradientEstimator estimator);
  void Compute(int y, int z);

  std::array<Row<Value>, 3> Components;

private:
  void Read(int y, int z);
  void SubtractNeighbours(int ahead, int behind);
  void SubtractPlanes();
  void WeighAlongX(Row<Value>& sum, const Row<Value>& smoothed, const Row<Value>& middle) const;

  RowReader<Value> Reader;
  std::array<int, 3> Dimensions;
  GradientEstimator Estimator;
  /// Rows[y][z]: 0 is behind the row, 1 at it, 2 ahead. Each has one more voxel at both ends.
  std::array<std::array<Row<Value>, 3>, 3> Rows;
  std::array<Row<Value>, 3> SmoothedAlongZ;
  Row<Value> SmoothedAlongY;
  Row<Value> Across;
  Row<Value> Behind;
  Row<Value> Ahead;
};

/// Calls use(row, z, components) for every row of voxels, those of one slice in their order.
template <typename Value, typename Use>
void ForEachRow(vtkDataArray* scalars, const std::array<int, 3>& dimensions,
  GradientEstimator estimator, const Use& use)
{
  const RowReader<Value> reader = MakeRowReader<Value>(scalars, dimensions[0]);
  vtkSMPTools::For(0, dimensions[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      RowDifferences<Value> differences(reader, dimensions, estimator);
      for (vtkIdType z = begin; z < end; ++z)
      {
        for (int y = 0; y < dimensions[1]; ++y)
        {
          differences.Compute(y, static_cast<int>(z));
          use(y + z * dimensions[1], z, differences.Components);
        }
      }
    });
}

}

#endif
