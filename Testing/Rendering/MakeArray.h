/**
 * @file MakeArray.h
 * @brief An array of any scalar type from its values.
 */
#ifndef MakeArray_h
#define MakeArray_h

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace penumbra
{
inline vtkSmartPointer<vtkDataArray> MakeArray(int type, const std::vector<double>& values)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  for (const double value : values)
  {
    array->InsertNextTuple1(value);
  }
  return array;
}
}

#endif
