#include "MaterialPreparation.h"

#include "DrawnScene.h"
#include "EnvironmentTextures.h"
#include "GradientNoise.h"
#include "PictureRequest.h"
#include "VolumeTextures.h"

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkVolumeMaterial.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
bool IsShaded(const PictureRequest& request)
{
  const int model = request.Mapper->GetOpticalModel();
  return model == vtkIlluminatedVolumeMapper::SingleScattering ||
    (model == vtkIlluminatedVolumeMapper::ByShade && request.Property->GetShade(0));
}

// Differences per voxel have the noise of their estimator along each axis, and so the gradient, a
// linear map of them, has that times the map's Frobenius norm.
void PrepareNoiseFading(vtkVolumeMaterial* material, DrawnScene& scene, VolumeTextures& textures)
{
  Matrix3 map = scene.Placement.GetGradientToMagnitude();
  double squares = 0.0;
  for (const double element : map)
  {
    squares += element * element;
  }
  const double noise = GradientNoise(textures.GetNoise(), scene.Requirements.Gradient);
  constexpr double largest = 1e30;
  const double factor = std::min(
    textures.GetScalarUnit() / (material->GetNoiseFading() * noise * std::sqrt(squares)), largest);
  for (double& element : map)
  {
    element *= factor;
  }
  scene.Material.GradientToNoise = map;
  scene.Material.FadedReflection = scene.Requirements.TwoSidedLighting ? 0.5 : 0.25;
}
}

//------------------------------------------------------------------------------
bool PrepareEnvironment(const PictureRequest& request, EnvironmentTextures& environment,
  std::vector<std::string>& messages)
{
  if (!IsShaded(request) || GetReflectionModel(request.Property) != ReflectionModel::ReflectionMap)
  {
    return false;
  }
  std::string reason;
  const bool usable =
    environment.Update(request.Window, vtkVolumeMaterial::SafeDownCast(request.Property), reason);
  if (!usable)
  {
    messages.push_back("No environment map is reflected: " + reason + ".");
  }
  return usable;
}

//------------------------------------------------------------------------------
void PrepareMaterial(const PictureRequest& request, DrawnScene& scene, VolumeTextures& textures)
{
  scene.Material = MakeMaterialUniforms(request.Property, scene.Placement);
  if (scene.Requirements.NoiseFading)
  {
    PrepareNoiseFading(vtkVolumeMaterial::SafeDownCast(request.Property), scene, textures);
  }
}

}
