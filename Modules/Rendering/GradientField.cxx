#include "GradientField.h"

#include "ScalarTexture.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace penumbra
{
namespace
{
/// Values of voxels along x.
using Row = std::vector<double>;
using RowReader = std::function<void(vtkIdType row, double* values)>;

template <typename Scalar>
RowReader MakeRowReader(const Scalar* scalars, int length, const ScalarRange& range)
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

RowReader MakeRowReader(vtkDataArray* scalars, int length)
{
  // Sobel's sums of larger values would overflow.
  constexpr double largest = 1e300;
  ScalarRange range = ComputeScalarRange(scalars);
  range.Low = std::clamp(range.Low, -largest, largest);
  range.High = std::clamp(range.High, -largest, largest);
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      return MakeRowReader(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), length, range));
  }
  return [length](vtkIdType, double* values) { std::fill_n(values, length, 0.0); };
}

void Subtract(Row& component, const double* ahead, const double* behind, double divisor)
{
  for (size_t x = 0; x < component.size(); ++x)
  {
    component[x] = (ahead[x] - behind[x]) / divisor;
  }
}

void Smooth(Row& sum, const Row& behind, const Row& middle, const Row& ahead)
{
  for (size_t x = 0; x < sum.size(); ++x)
  {
    sum[x] = behind[x] + 3.0 * middle[x] + ahead[x];
  }
}

/// SobelWeights is 1-3-1 along one axis times 1-3-1 along the other, less 3 in the middle: this
/// takes values that are smoothed along one axis, and the middle as it was.
void Weigh(Row& sum, const double* smoothedBehind, const double* smoothed,
  const double* smoothedAhead, const double* middle)
{
  for (size_t x = 0; x < sum.size(); ++x)
  {
    sum[x] = smoothedBehind[x] + 3.0 * smoothed[x] + smoothedAhead[x] - 3.0 * middle[x];
  }
}

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

RowGradients::RowGradients(
  RowReader reader, const std::array<int, 3>& dimensions, GradientEstimator estimator)
  : Reader(std::move(reader))
  , Dimensions(dimensions)
  , Estimator(estimator)
  , SmoothedAlongY(dimensions[0] + 2)
  , Across(dimensions[0] + 2)
  , Behind(dimensions[0])
  , Ahead(dimensions[0])
{
  const Row padded(dimensions[0] + 2);
  this->Components.fill(Row(dimensions[0]));
  this->Rows.fill({ padded, padded, padded });
  this->SmoothedAlongZ.fill(padded);
}

void RowGradients::Compute(int y, int z)
{
  this->Read(y, z);
  switch (this->Estimator)
  {
    case GradientEstimator::CentralDifferences:
      return this->SubtractNeighbours(2, 0, 2.0);
    case GradientEstimator::ForwardDifferences:
      return this->SubtractNeighbours(2, 1, 1.0);
    case GradientEstimator::BackwardDifferences:
      return this->SubtractNeighbours(1, 0, 1.0);
    case GradientEstimator::Sobel:
      return this->SubtractPlanes();
  }
}

void RowGradients::Read(int y, int z)
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
      Row& row = this->Rows[dy + 1][dz + 1];
      this->Reader(rowY + rowZ * this->Dimensions[1], row.data() + 1);
      row.front() = row[1];
      row.back() = row[row.size() - 2];
    }
  }
}

void RowGradients::SubtractNeighbours(int ahead, int behind, double divisor)
{
  const auto& rows = this->Rows;
  auto& [dx, dy, dz] = this->Components;
  Subtract(dx, &rows[1][1][ahead], &rows[1][1][behind], divisor);
  Subtract(dy, &rows[ahead][1][1], &rows[behind][1][1], divisor);
  Subtract(dz, &rows[1][ahead][1], &rows[1][behind][1], divisor);
}

void RowGradients::SubtractPlanes()
{
  constexpr double divisor = 44.0;
  const auto& rows = this->Rows;
  auto& smoothed = this->SmoothedAlongZ;
  auto& [dx, dy, dz] = this->Components;
  for (int y = 0; y < 3; ++y)
  {
    Smooth(smoothed[y], rows[y][0], rows[y][1], rows[y][2]);
  }
  Weigh(this->Across, &smoothed[0][0], &smoothed[1][0], &smoothed[2][0], &rows[1][1][0]);
  Subtract(dx, &this->Across[2], &this->Across[0], divisor);

  this->WeighAlongX(this->Behind, smoothed[0], rows[0][1]);
  this->WeighAlongX(this->Ahead, smoothed[2], rows[2][1]);
  Subtract(dy, &this->Ahead[0], &this->Behind[0], divisor);

  Smooth(this->SmoothedAlongY, rows[0][0], rows[1][0], rows[2][0]);
  this->WeighAlongX(this->Behind, this->SmoothedAlongY, rows[1][0]);
  Smooth(this->SmoothedAlongY, rows[0][2], rows[1][2], rows[2][2]);
  this->WeighAlongX(this->Ahead, this->SmoothedAlongY, rows[1][2]);
  Subtract(dz, &this->Ahead[0], &this->Behind[0], divisor);
}

void RowGradients::WeighAlongX(Row& sum, const Row& smoothed, const Row& middle) const
{
  Weigh(sum, &smoothed[0], &smoothed[1], &smoothed[2], &middle[1]);
}

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

double FindLargestComponent(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
{
  Row largest(dimensions[2], 0.0);
  ForEachRow(scalars, dimensions, estimator,
    [&](vtkIdType, vtkIdType z, const std::array<Row, 3>& components)
    {
      for (const Row& component : components)
      {
        for (const double value : component)
        {
          largest[z] = std::max(largest[z], std::abs(value));
        }
      }
    });
  return largest.empty() ? 0.0 : *std::max_element(largest.begin(), largest.end());
}

/// What quantization does to gradients, whose largest component counts as 1.
struct QuantizationErrors
{
  double Largest = 0.0;
  double WeightedAngles = 0.0;
  double Weights = 0.0;

  void Add(const double exact[3], const double quantized[3]);
};

void QuantizationErrors::Add(const double exact[3], const double quantized[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Largest = std::max(this->Largest, std::abs(quantized[axis] - exact[axis]));
  }
  double normal[3];
  vtkMath::Cross(exact, quantized, normal);
  const double magnitude = vtkMath::Norm(exact);
  const bool vanished = vtkMath::Dot(quantized, quantized) == 0.0;
  const double angle = vanished ? 0.5 * vtkMath::Pi()
                                : std::atan2(vtkMath::Norm(normal), vtkMath::Dot(exact, quantized));
  this->WeightedAngles += magnitude * angle;
  this->Weights += magnitude;
}

/// Returns the errors of each slice, so that threads do not change the order of their sums.
template <typename Value>
std::vector<QuantizationErrors> Quantize(vtkDataArray* scalars,
  const std::array<int, 3>& dimensions, GradientEstimator estimator, double scale, Value* values)
{
  constexpr double largest = std::numeric_limits<Value>::max();
  std::vector<QuantizationErrors> errors(dimensions[2]);
  ForEachRow(scalars, dimensions, estimator,
    [&](vtkIdType row, vtkIdType z, const std::array<Row, 3>& components)
    {
      Value* value = values + 3 * row * dimensions[0];
      for (int x = 0; x < dimensions[0]; ++x)
      {
        double exact[3];
        double quantized[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          exact[axis] = components[axis][x] / scale;
          *value = static_cast<Value>(exact[axis] * largest + std::copysign(0.5, exact[axis]));
          quantized[axis] = *value++ / largest;
        }
        errors[z].Add(exact, quantized);
      }
    });
  return errors;
}

void SetErrors(QuantizedGradientField& field, const std::vector<QuantizationErrors>& slices)
{
  QuantizationErrors total;
  for (const QuantizationErrors& slice : slices)
  {
    total.Largest = std::max(total.Largest, slice.Largest);
    total.WeightedAngles += slice.WeightedAngles;
    total.Weights += slice.Weights;
  }
  field.LargestError = field.Scale * total.Largest;
  field.MeanAngularError = vtkMath::DegreesFromRadians(total.WeightedAngles / total.Weights);
}
}

//------------------------------------------------------------------------------
std::vector<float> ComputeGradientField(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
{
  std::vector<float> gradients(3 * scalars->GetNumberOfTuples());
  ForEachRow(scalars, dimensions, estimator,
    [&](vtkIdType row, vtkIdType, const std::array<Row, 3>& components)
    {
      float* gradient = gradients.data() + 3 * row * dimensions[0];
      for (int x = 0; x < dimensions[0]; ++x)
      {
        for (const Row& component : components)
        {
          *gradient++ = static_cast<float>(component[x]);
        }
      }
    });
  return gradients;
}

//------------------------------------------------------------------------------
QuantizedGradientField QuantizeGradientField(vtkDataArray* scalars,
  const std::array<int, 3>& dimensions, GradientEstimator estimator, int bits)
{
  QuantizedGradientField field;
  field.Bits = bits;
  field.Scale = FindLargestComponent(scalars, dimensions, estimator);
  const std::size_t count = 3 * scalars->GetNumberOfTuples();
  field.Bytes = count * bits / 8;
  field.Values8.resize(bits == 8 ? count : 0);
  field.Values16.resize(bits == 8 ? 0 : count);
  if (field.Scale > 0.0)
  {
    SetErrors(field,
      bits == 8 ? Quantize(scalars, dimensions, estimator, field.Scale, field.Values8.data())
                : Quantize(scalars, dimensions, estimator, field.Scale, field.Values16.data()));
  }
  return field;
}

}
