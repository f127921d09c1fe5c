#include "TakenOver.h"

#include "vtkDataArray.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMultiVolume.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace penumbra
{
namespace
{
std::string CheckInput(vtkGPUVolumeRayCastMapper* mapper, vtkDataArray* scalars, bool cellData)
{
  if (mapper->GetInputCount() > 1)
  {
    return "Several inputs";
  }
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (!image)
  {
    return "Input other than vtkImageData";
  }
  if (image->GetPointGhostArray() || image->GetCellGhostArray())
  {
    return "Blanking";
  }
  if (cellData)
  {
    return "Cell data";
  }
  return scalars && scalars->GetNumberOfComponents() > 1 ? "Several components" : "";
}

std::string CheckProperty(vtkVolumeProperty* property)
{
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "A two-dimensional transfer function";
  }
  if (property->GetUseClippedVoxelIntensity())
  {
    return "Clipped voxel intensity";
  }
  return "";
}

std::string CheckMapper(vtkGPUVolumeRayCastMapper* mapper)
{
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    return "A blend mode other than composite";
  }
  if (mapper->GetMaskInput() && mapper->GetMaskType() != vtkGPUVolumeRayCastMapper::BinaryMaskType)
  {
    return "A label map";
  }
  if (mapper->GetRenderToImage())
  {
    return "Render to image";
  }
  if (mapper->GetUseDepthPass())
  {
    return "The depth pass";
  }
  if (mapper->GetFinalColorWindow() != 1.0f || mapper->GetFinalColorLevel() != 0.5f)
  {
    return "Final colour window and level";
  }
  return "";
}

bool HasRenderPasses(vtkVolume* volume)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  return keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()) &&
    keys->Length(vtkOpenGLRenderPass::RenderPasses()) > 0;
}
}

//------------------------------------------------------------------------------
std::string FindWhatIsNotTakenOver(vtkGPUVolumeRayCastMapper* mapper, vtkDataArray* scalars,
  bool cellData, vtkRenderer* renderer, vtkVolume* volume)
{
  if (vtkMultiVolume::SafeDownCast(volume))
  {
    return "Multi-volume";
  }
  if (renderer->GetSelector())
  {
    return "Picking";
  }
  if (HasRenderPasses(volume))
  {
    return "A render pass that changes volume shaders";
  }
  for (const std::string& reason : { CheckMapper(mapper), CheckInput(mapper, scalars, cellData),
         CheckProperty(volume->GetProperty()) })
  {
    if (!reason.empty())
    {
      return reason;
    }
  }
  return "";
}

}
