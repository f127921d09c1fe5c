#include "GradientRows.h"

#include "ScalarRange.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <utility>

namespace penumbra
{
namespace
{
template <typename Scalar>
RowReader<int> ReadWhole(const Scalar* scalars, int length)
{
  return [=](vtkIdType row, int* values)
  {
    std::transform(scalars + row * length, scalars + (row + 1) * length, values,
      [](Scalar scalar) { return static_cast<int>(scalar); });
  };
}

template <typename Scalar>
RowReader<double> ReadFinite(const Scalar* scalars, int length, const ScalarRange& range)
{
  return [=](vtkIdType row, double* values)
  {
    const Scalar* first = scalars + row * length;
    for (int x = 0; x < length; ++x)
    {
      const double value = static_cast<double>(first[x]);
      // NaN is not above anything.
      values[x] = value > range.Low ? std::min(value, range.High) : range.Low;
    }
  };
}

template <typename Value>
void Subtract(Row<Value>& component, const Value* ahead, const Value* behind)
{
  for (size_t x = 0; x < component.size(); ++x)
  {
    component[x] = ahead[x] - behind[x];
  }
}

template <typename Value>
void Smooth(
  Row<Value>& sum, const Row<Value>& behind, const Row<Value>& middle, const Row<Value>& ahead)
{
  for (size_t x = 0; x < sum.size(); ++x)
  {
    sum[x] = behind[x] + 3 * middle[x] + ahead[x];
  }
}

/// SobelWeights is 1-3-1 along one axis times 1-3-1 along the other, less 3 in the middle: this
/// takes values that are smoothed along one axis, and the middle as it was.
template <typename Value>
void Weigh(Row<Value>& sum, const Value* smoothedBehind, const Value* smoothed,
  const Value* smoothedAhead, const Value* middle)
{
  for (size_t x = 0; x < sum.size(); ++x)
  {
    sum[x] = smoothedBehind[x] + 3 * smoothed[x] + smoothedAhead[x] - 3 * middle[x];
  }
}
}

//------------------------------------------------------------------------------
template <>
RowReader<int> MakeRowReader<int>(vtkDataArray* scalars, int length)
{
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      return ReadWhole(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), length));
  }
  return [length](vtkIdType, int* values) { std::fill_n(values, length, 0); };
}

//------------------------------------------------------------------------------
template <>
RowReader<double> MakeRowReader<double>(vtkDataArray* scalars, int length)
{
  // Sobel's sums of larger values would overflow.
  constexpr double largest = 1e300;
  ScalarRange range = ComputeScalarRange(scalars);
  range.Low = std::clamp(range.Low, -largest, largest);
  range.High = std::clamp(range.High, -largest, largest);
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      return ReadFinite(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), length, range));
  }
  return [length](vtkIdType, double* values) { std::fill_n(values, length, 0.0); };
}

//------------------------------------------------------------------------------
double GetDifferenceDivisor(GradientEstimator estimator)
{
  constexpr double divisors[] = { 2.0, 1.0, 1.0, 44.0 };
  return divisors[static_cast<int>(estimator)];
}

//------------------------------------------------------------------------------
template <typename Value>
RowDifferences<Value>::RowDifferences(
  RowReader<Value> reader, const std::array<int, 3>& dimensions, GradientEstimator estimator)
  : Reader(std::move(reader))
  , Dimensions(dimensions)
  , Estimator(estimator)
  , SmoothedAlongY(dimensions[0] + 2)
  , Across(dimensions[0] + 2)
  , Behind(dimensions[0])
  , Ahead(dimensions[0])
{
  const Row<Value> padded(dimensions[0] + 2);
  this->Components.fill(Row<Value>(dimensions[0]));
  this->Rows.fill({ padded, padded, padded });
  this->SmoothedAlongZ.fill(padded);
}

//------------------------------------------------------------------------------
template <typename Value>
void RowDifferences<Value>::Compute(int y, int z)
{
  this->Read(y, z);
  switch (this->Estimator)
  {
    case GradientEstimator::CentralDifferences:
      return this->SubtractNeighbours(2, 0);
    case GradientEstimator::ForwardDifferences:
      return this->SubtractNeighbours(2, 1);
    case GradientEstimator::BackwardDifferences:
      return this->SubtractNeighbours(1, 0);
    case GradientEstimator::Sobel:
      return this->SubtractPlanes();
  }
}

//------------------------------------------------------------------------------
template <typename Value>
void RowDifferences<Value>::Read(int y, int z)
{
  for (int dy = -1; dy <= 1; ++dy)
  {
    for (int dz = -1; dz <= 1; ++dz)
    {
      if (dy != 0 && dz != 0 && this->Estimator != GradientEstimator::Sobel)
      {
        continue;
      }
      const vtkIdType rowY = std::clamp(y + dy, 0, this->Dimensions[1] - 1);
      const vtkIdType rowZ = std::clamp(z + dz, 0, this->Dimensions[2] - 1);
      Row<Value>& row = this->Rows[dy + 1][dz + 1];
      this->Reader(rowY + rowZ * this->Dimensions[1], row.data() + 1);
      row.front() = row[1];
      row.back() = row[row.size() - 2];
    }
  }
}

//------------------------------------------------------------------------------
template <typename Value>
void RowDifferences<Value>::SubtractNeighbours(int ahead, int behind)
{
  const auto& rows = this->Rows;
  auto& [dx, dy, dz] = this->Components;
  Subtract<Value>(dx, &rows[1][1][ahead], &rows[1][1][behind]);
  Subtract<Value>(dy, &rows[ahead][1][1], &rows[behind][1][1]);
  Subtract<Value>(dz, &rows[1][ahead][1], &rows[1][behind][1]);
}

//------------------------------------------------------------------------------
template <typename Value>
void RowDifferences<Value>::SubtractPlanes()
{
  const auto& rows = this->Rows;
  auto& smoothed = this->SmoothedAlongZ;
  auto& [dx, dy, dz] = this->Components;
  for (int y = 0; y < 3; ++y)
  {
    Smooth(smoothed[y], rows[y][0], rows[y][1], rows[y][2]);
  }
  Weigh(this->Across, &smoothed[0][0], &smoothed[1][0], &smoothed[2][0], &rows[1][1][0]);
  Subtract<Value>(dx, &this->Across[2], &this->Across[0]);

  this->WeighAlongX(this->Behind, smoothed[0], rows[0][1]);
  this->WeighAlongX(this->Ahead, smoothed[2], rows[2][1]);
  Subtract<Value>(dy, &this->Ahead[0], &this->Behind[0]);

  Smooth(this->SmoothedAlongY, rows[0][0], rows[1][0], rows[2][0]);
  this->WeighAlongX(this->Behind, this->SmoothedAlongY, rows[1][0]);
  Smooth(this->SmoothedAlongY, rows[0][2], rows[1][2], rows[2][2]);
  this->WeighAlongX(this->Ahead, this->SmoothedAlongY, rows[1][2]);
  Subtract<Value>(dz, &this->Ahead[0], &this->Behind[0]);
}

//------------------------------------------------------------------------------
template <typename Value>
void RowDifferences<Value>::WeighAlongX(
  Row<Value>& sum, const Row<Value>& smoothed, const Row<Value>& middle) const
{
  Weigh<Value>(sum, &smoothed[0], &smoothed[1], &smoothed[2], &middle[1]);
}

template class RowDifferences<int>;
template class RowDifferences<double>;

}
