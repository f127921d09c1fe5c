#include "GradientField.h"

#include "GradientRows.h"

#include "vtkDataArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra
{
namespace
{
double FindLargestComponent(
  vtkDataArray* scalars, const std::array<int, 3>& dimensions, GradientEstimator estimator)
{
  Row<double> largest(dimensions[2], 0.0);
  ForEachRow<double>(scalars, dimensions, estimator,
    [&](vtkIdType, vtkIdType z, const std::array<Row<double>, 3>& components)
    {
      for (const Row<double>& component : components)
      {
        for (const double value : component)
        {
          largest[z] = std::max(largest[z], std::abs(value));
        }
      }
    });
  return largest.empty()
    ? 0.0
    : *std::max_element(largest.begin(), largest.end()) / GetDifferenceDivisor(estimator);
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
  const double divisor = GetDifferenceDivisor(estimator);
  std::vector<QuantizationErrors> errors(dimensions[2]);
  ForEachRow<double>(scalars, dimensions, estimator,
    [&](vtkIdType row, vtkIdType z, const std::array<Row<double>, 3>& components)
    {
      Value* value = values + 3 * row * dimensions[0];
      for (int x = 0; x < dimensions[0]; ++x)
      {
        double exact[3];
        double quantized[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          exact[axis] = components[axis][x] / divisor / scale;
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
  const double divisor = GetDifferenceDivisor(estimator);
  std::vector<float> gradients(3 * scalars->GetNumberOfTuples());
  ForEachRow<double>(scalars, dimensions, estimator,
    [&](vtkIdType row, vtkIdType, const std::array<Row<double>, 3>& components)
    {
      float* gradient = gradients.data() + 3 * row * dimensions[0];
      for (int x = 0; x < dimensions[0]; ++x)
      {
        for (const Row<double>& component : components)
        {
          *gradient++ = static_cast<float>(component[x] / divisor);
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
