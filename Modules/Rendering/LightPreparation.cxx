#include "LightPreparation.h"

#include "DrawnScene.h"
#include "MaterialPreparation.h"
#include "PictureRequest.h"
#include "TexturePreparation.h"
#include "VolumeDrawing.h"

#include "vtkCamera.h"
#include "vtkIlluminatedVolumeMapper.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

namespace penumbra
{
namespace
{
std::optional<OpticalModel> GetOptics(vtkIlluminatedVolumeMapper* mapper)
{
  const int model = mapper->GetOpticalModel();
  if (model == vtkIlluminatedVolumeMapper::ByShade)
  {
    return std::nullopt;
  }
  return static_cast<OpticalModel>(model - vtkIlluminatedVolumeMapper::Absorption);
}

LightedScene DescribeLighting(const PictureRequest& request, vtkLightCollection* lights,
  const DrawnScene& scene, VolumeDrawing& drawing, std::vector<std::string>& messages)
{
  VolumeTextures& textures = drawing.GetTextures();
  const TransferFunctionTable& functions = textures.GetTransferFunctions().GetTable();
  vtkIlluminatedVolumeMapper* mapper = request.Mapper;
  LightedScene lighted;
  lighted.Property = request.Property;
  lighted.Lights = lights;
  lighted.TwoSidedLighting = request.Renderer->GetTwoSidedLighting() != 0;
  lighted.ClippingPlanes = static_cast<int>(scene.ClippingPlanes.size());
  lighted.Cropping = scene.Cropping;
  lighted.Mask = textures.HasMask();
  lighted.Opacity = functions.Lookup;
  lighted.SteepOpacity = functions.Steep;
  lighted.LinearInterpolation =
    request.Property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  lighted.Optics = GetOptics(mapper);
  lighted.Gradient = static_cast<GradientEstimator>(mapper->GetGradientEstimator());
  lighted.EnvironmentMap = PrepareEnvironment(request, drawing.GetEnvironment(), messages);
  lighted.GradientTexture = GetGradientTextureBits(request, textures) > 0;
  lighted.EmptySpace = PrepareEmptySpace(request, scene, textures);
  return lighted;
}
}

//------------------------------------------------------------------------------
void PrepareLights(const PictureRequest& request, DrawnScene& scene, VolumeDrawing& drawing,
  std::vector<std::string>& messages)
{
  vtkLightCollection* all = request.Renderer->GetLights();
  vtkNew<vtkLightCollection> lights;
  const int largestNumber = LightUniforms::GetLargestNumber(request.Window);
  const int left = CollectLights(all, request.Property, largestNumber, lights);
  scene.Requirements =
    ComputeLightingRequirements(DescribeLighting(request, lights, scene, drawing, messages));
  if (left > 0 && scene.Requirements.IsShaded())
  {
    messages.push_back("The graphics card's shaders hold " + std::to_string(largestNumber) +
      " lights; the last " + std::to_string(left) + " give ambient light only.");
  }
  Vector3 cameraDirection;
  request.Renderer->GetActiveCamera()->GetDirectionOfProjection(cameraDirection.data());
  scene.Lights =
    MakeLightUniforms(lights, request.Property, scene.Placement, Normalized(cameraDirection));
  scene.Lights.SetAmbient(ComputeAmbientLight(all), request.Property->GetAmbient(0));
}

}
