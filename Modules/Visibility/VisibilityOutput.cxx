#include "VisibilityOutput.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace penumbra
{
namespace
{
void AddArrays(vtkImageData* output, VisibilityTask& task)
{
  task.Stride = 1;
  for (const ShadowedLight& light : task.Lights)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(light.GetName().c_str());
    array->SetNumberOfTuples(output->GetNumberOfPoints());
    output->GetPointData()->AddArray(array);
    task.Values.push_back(array->GetPointer(0));
  }
  output->GetPointData()->SetActiveScalars(task.Lights.front().GetName().c_str());
}

//------------------------------------------------------------------------------
void AddPackedArray(vtkImageData* output, VisibilityTask& task)
{
  task.Stride = static_cast<vtkIdType>(task.Lights.size());
  vtkNew<vtkFloatArray> array;
  array->SetName("Visibility");
  array->SetNumberOfComponents(static_cast<int>(task.Stride));
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  for (int light = 0; light < static_cast<int>(task.Stride); ++light)
  {
    array->SetComponentName(light, task.Lights[light].GetName().c_str());
    task.Values.push_back(array->GetPointer(0) + light);
  }
  output->GetPointData()->SetScalars(array);
}
}

//------------------------------------------------------------------------------
ImageGeometry GetImageGeometry(vtkInformation* information)
{
  ImageGeometry geometry;
  geometry.Extent = { 0, -1, 0, -1, 0, -1 };
  geometry.Spacing = { 1.0, 1.0, 1.0 };
  geometry.Direction = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  const auto get = [information](auto* key, auto& values)
  {
    if (information->Has(key))
    {
      information->Get(key, values.data());
    }
  };
  get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), geometry.Extent);
  get(vtkDataObject::ORIGIN(), geometry.Origin);
  get(vtkDataObject::SPACING(), geometry.Spacing);
  get(vtkDataObject::DIRECTION(), geometry.Direction);
  return geometry;
}

//------------------------------------------------------------------------------
void SetImageGeometry(const ImageGeometry& geometry, vtkInformation* information)
{
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), geometry.Extent.data(), 6);
  information->Set(vtkDataObject::ORIGIN(), geometry.Origin.data(), 3);
  information->Set(vtkDataObject::SPACING(), geometry.Spacing.data(), 3);
  information->Set(vtkDataObject::DIRECTION(), geometry.Direction.data(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
}

//------------------------------------------------------------------------------
void AllocateVisibility(
  vtkInformation* information, bool packed, vtkImageData* output, VisibilityTask& task)
{
  const ImageGeometry whole = GetImageGeometry(information);
  int extent[6];
  information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    task.Points[side] = extent[side] - whole.Extent[2 * axis];
    task.NumberOfPoints[axis] = whole.Extent[2 * axis + 1] - whole.Extent[2 * axis] + 1;
  }
  output->SetExtent(extent);
  output->SetOrigin(whole.Origin.data());
  output->SetSpacing(whole.Spacing.data());
  output->SetDirectionMatrix(whole.Direction.data());
  packed ? AddPackedArray(output, task) : AddArrays(output, task);
}

}
