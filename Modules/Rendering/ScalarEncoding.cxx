#include "ScalarEncoding.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr double LargestNormalized = 65535.0;

template <typename Scalar>
void EncodeNormalized(
  const Scalar* scalars, const ScalarEncoding& encoding, std::vector<unsigned short>& values)
{
  const double factor = LargestNormalized / encoding.Scale;
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        const double value = (static_cast<double>(scalars[voxel]) - encoding.Offset) * factor;
        values[voxel] = static_cast<unsigned short>(value + 0.5);
      }
    });
}

template <typename Scalar>
void EncodeFloat(const Scalar* scalars, const ScalarEncoding& encoding, const ScalarRange& range,
  std::vector<float>& values)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType voxel = begin; voxel < end; ++voxel)
      {
        double value = static_cast<double>(scalars[voxel]);
        value = std::isnan(value) ? range.Low : std::clamp(value, range.Low, range.High);
        values[voxel] = static_cast<float>((value - encoding.Offset) / encoding.Scale);
      }
    });
}
}

//------------------------------------------------------------------------------
ScalarEncoding ChooseEncoding(int scalarType, const ScalarRange& range)
{
  switch (scalarType)
  {
    case VTK_UNSIGNED_CHAR:
      return { true, 255.0, 0.0 };
    case VTK_SIGNED_CHAR:
      return { true, 255.0, -128.0 };
    case VTK_UNSIGNED_SHORT:
      return { true, LargestNormalized, 0.0 };
    case VTK_SHORT:
      return { true, LargestNormalized, -32768.0 };
    default:
      break;
  }
  // Without an offset values near 0 keep digits of their own, which faint gradients need; with one,
  // values far from 0 keep those of their range.
  constexpr double farFromZero = 8.0;
  const double middle = 0.5 * range.Low + 0.5 * range.High;
  const double halfRange = 0.5 * range.High - 0.5 * range.Low;
  ScalarEncoding encoding;
  encoding.Offset = std::abs(middle) > farFromZero * halfRange ? middle : 0.0;
  // Floats overflow, or lose digits one by one, beyond these.
  constexpr double huge = 1e30;
  constexpr double tiny = 1e-20;
  const double magnitude =
    std::max(std::abs(range.Low - encoding.Offset), std::abs(range.High - encoding.Offset));
  if (magnitude > huge || (magnitude > 0.0 && magnitude < tiny))
  {
    encoding.Scale = magnitude;
  }
  return encoding;
}

//------------------------------------------------------------------------------
std::vector<unsigned short> EncodeNormalized(vtkDataArray* scalars, const ScalarEncoding& encoding)
{
  std::vector<unsigned short> values(scalars->GetNumberOfTuples());
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      EncodeNormalized(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), encoding, values));
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<float> EncodeFloat(
  vtkDataArray* scalars, const ScalarEncoding& encoding, const ScalarRange& range)
{
  std::vector<float> values(scalars->GetNumberOfTuples());
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(
      EncodeFloat(static_cast<VTK_TT*>(scalars->GetVoidPointer(0)), encoding, range, values));
  }
  return values;
}

}
