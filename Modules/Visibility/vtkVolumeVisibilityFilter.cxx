#include "vtkVolumeVisibilityFilter.h"

#include "VisibilityOutput.h"
#include "VisibilityScene.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersion.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

using namespace penumbra;

vtkStandardNewMacro(vtkVolumeVisibilityFilter);
vtkCxxSetObjectMacro(vtkVolumeVisibilityFilter, VolumeProperty, vtkVolumeProperty);
vtkCxxSetObjectMacro(vtkVolumeVisibilityFilter, Lights, vtkLightCollection);
vtkCxxSetObjectMacro(vtkVolumeVisibilityFilter, Matrix, vtkMatrix4x4);
vtkCxxSetObjectMacro(vtkVolumeVisibilityFilter, ClippingPlanes, vtkPlaneCollection);

namespace
{
template <typename Collection, typename Visitor>
void VisitItems(Collection* collection, Visitor visit)
{
  for (int item = 0; collection && item < collection->GetNumberOfItems(); ++item)
  {
    visit(collection->GetItemAsObject(item));
  }
}
}

//------------------------------------------------------------------------------
vtkVolumeVisibilityFilter::vtkVolumeVisibilityFilter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkVolumeVisibilityFilter::~vtkVolumeVisibilityFilter()
{
  this->SetVolumeProperty(nullptr);
  this->SetLights(nullptr);
  this->SetMatrix(nullptr);
  this->SetClippingPlanes(nullptr);
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::AddLight(vtkLight* light)
{
  if (!this->Lights)
  {
    this->SetLights(vtkNew<vtkLightCollection>());
  }
  this->Lights->AddItem(light);
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::RemoveAllLights()
{
  this->SetLights(nullptr);
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::AddClippingPlane(vtkPlane* plane)
{
  if (!this->ClippingPlanes)
  {
    this->SetClippingPlanes(vtkNew<vtkPlaneCollection>());
  }
  this->ClippingPlanes->AddItem(plane);
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::RemoveAllClippingPlanes()
{
  this->SetClippingPlanes(nullptr);
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::SetMaskData(vtkImageData* mask)
{
  this->SetInputDataInternal(1, mask);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeVisibilityFilter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto cover = [&time](vtkObject* part)
  { time = std::max(time, part ? part->GetMTime() : vtkMTimeType{ 0 }); };
  cover(this->VolumeProperty);
  cover(this->Matrix);
  cover(this->Lights);
  cover(this->ClippingPlanes);
  VisitItems(this->ClippingPlanes, cover);
  VisitItems(this->Lights,
    [&](vtkObject* light)
    {
      cover(light);
      cover(vtkLight::SafeDownCast(light)->GetTransformMatrix());
    });
  return time;
}

//------------------------------------------------------------------------------
int vtkVolumeVisibilityFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1 ? 1 : 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeVisibilityFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const ImageGeometry volume = GetImageGeometry(inputs[0]->GetInformationObject(0));
  std::array<int, 3> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int voxels = volume.Extent[2 * axis + 1] - volume.Extent[2 * axis] + 1;
    const int asked = this->OutputDimensions[axis];
    points[axis] = asked > 0 && voxels > 0 ? asked : GetNumberOfPoints(voxels, this->Resolution);
  }
  SetImageGeometry(ComputeOutputGeometry(volume, points), outputs->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
// Any point may need all of the volume.
int vtkVolumeVisibilityFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* input = inputs[port]->GetInformationObject(0))
    {
      input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
        input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkVolumeVisibilityFilter::IsAborted()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return this->CheckAbort();
#else
  return this->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
VisibilityScene vtkVolumeVisibilityFilter::GetScene(vtkInformationVector** inputs)
{
  VisibilityScene scene;
  scene.Volume = vtkImageData::GetData(inputs[0]);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(0, inputs, association);
  scene.Scalars = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ? array : nullptr;
  scene.Mask = vtkImageData::GetData(inputs[1]);
  scene.Property = this->VolumeProperty;
  scene.Lights = this->Lights;
  std::copy_n(this->CameraDirection, 3, scene.CameraDirection.begin());
  scene.Matrix = this->Matrix;
  scene.ClippingPlanes = this->ClippingPlanes;
  scene.CroppingPlanes = this->Cropping ? this->CroppingRegionPlanes : nullptr;
  scene.Estimator = static_cast<penumbra::GradientEstimator>(this->GradientEstimator);
  scene.SampleDistance = this->SampleDistance;
  scene.NegligibleVisibility = this->NegligibleVisibility;
  return scene;
}

//------------------------------------------------------------------------------
int vtkVolumeVisibilityFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  const VisibilityScene scene = this->GetScene(inputs);
  const std::string obstacle = FindObstacle(scene);
  // Why there is no output has been told; the pipeline would add nothing but lines.
  if (!obstacle.empty())
  {
    vtkErrorMacro(<< obstacle);
    return 1;
  }
  const UsableScalars scalars = MakeUsableScalars(scene.Scalars);
  if (scalars.Replaced)
  {
    vtkWarningMacro("Voxels that are NaN or -Inf count as the smallest finite value of the volume, "
                    "+Inf as the largest.");
  }
  VisibilityTask task = MakeVisibilityTask(scene, scalars);
  AllocateVisibility(outputs->GetInformationObject(0), this->PackArrays, output, task);
  const auto progress = [this](double part)
  {
    this->UpdateProgress(part);
    return !this->IsAborted();
  };
  if (!task.Run(progress))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkVolumeVisibilityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto* values, int count)
  {
    os << indent << name << ":";
    std::for_each(values, values + count, [&](auto value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "VolumeProperty: " << this->VolumeProperty << "\n";
  os << indent << "Lights: " << this->Lights << "\n";
  print("CameraDirection", this->CameraDirection, 3);
  os << indent << "Matrix: " << this->Matrix << "\n";
  os << indent << "ClippingPlanes: " << this->ClippingPlanes << "\n";
  os << indent << "Cropping: " << (this->Cropping ? "On" : "Off") << "\n";
  print("CroppingRegionPlanes", this->CroppingRegionPlanes, 6);
  static const char* const estimators[] = { "CentralDifferences", "ForwardDifferences",
    "BackwardDifferences", "Sobel" };
  os << indent << "GradientEstimator: " << estimators[this->GradientEstimator] << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  print("OutputDimensions", this->OutputDimensions, 3);
  os << indent << "NegligibleVisibility: " << this->NegligibleVisibility << "\n";
  os << indent << "PackArrays: " << (this->PackArrays ? "On" : "Off") << "\n";
}
