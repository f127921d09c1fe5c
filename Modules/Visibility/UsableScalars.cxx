#include "UsableScalars.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
template <typename Value>
bool AreFinite(const Value* values, vtkIdType count)
{
  return std::all_of(values, values + count, [](Value value) { return std::isfinite(value); });
}

//------------------------------------------------------------------------------
template <typename Value>
void Replace(Value* values, vtkIdType count, double low, double high)
{
  // NaN is not above anything.
  std::transform(values, values + count, values,
    [=](Value value)
    {
      return value > low ? static_cast<Value>(std::min<double>(value, high))
                         : static_cast<Value>(low);
    });
}

//------------------------------------------------------------------------------
bool AreFinite(vtkDataArray* array)
{
  const vtkIdType count = array->GetNumberOfTuples();
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
      return AreFinite(static_cast<const float*>(array->GetVoidPointer(0)), count);
    case VTK_DOUBLE:
      return AreFinite(static_cast<const double*>(array->GetVoidPointer(0)), count);
    default:
      return true;
  }
}

//------------------------------------------------------------------------------
void Replace(vtkDataArray* array, double low, double high)
{
  const vtkIdType count = array->GetNumberOfTuples();
  if (array->GetDataType() == VTK_FLOAT)
  {
    Replace(static_cast<float*>(array->GetVoidPointer(0)), count, low, high);
  }
  else
  {
    Replace(static_cast<double*>(array->GetVoidPointer(0)), count, low, high);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> Copy(vtkDataArray* array)
{
  const bool bits = array->GetDataType() == VTK_BIT;
  auto copy = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(bits ? VTK_UNSIGNED_CHAR : array->GetDataType()));
  copy->DeepCopy(array);
  return copy;
}
}

//------------------------------------------------------------------------------
UsableScalars MakeUsableScalars(vtkDataArray* scalars)
{
  UsableScalars usable;
  const bool inOnePiece = scalars->HasStandardMemoryLayout() && scalars->GetDataType() != VTK_BIT;
  usable.Array = inOnePiece ? vtkSmartPointer<vtkDataArray>(scalars) : Copy(scalars);
  double range[2];
  usable.Array->GetFiniteRange(range, 0);
  const bool anyFinite = range[0] <= range[1];
  usable.Low = anyFinite ? range[0] : 0.0;
  usable.High = anyFinite ? range[1] : 0.0;
  if (!AreFinite(usable.Array))
  {
    usable.Replaced = true;
    usable.Array = usable.Array == scalars ? Copy(scalars) : usable.Array;
    Replace(usable.Array, usable.Low, usable.High);
  }
  return usable;
}

}
