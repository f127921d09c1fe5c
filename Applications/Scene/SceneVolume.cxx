#include "SceneVolume.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlane.h>
#include <vtkVersionMacros.h>

#include <vtkIlluminatedVolumeMapper.h>

namespace penumbra
{
namespace
{
// VTK 9.1 keeps clipping planes in an array of this many.
constexpr std::size_t MostPlanesOfStockMapper = 8;

int OpticalModelOf(OpticalModel optics)
{
  switch (optics)
  {
    case OpticalModel::Absorption:
      return vtkIlluminatedVolumeMapper::Absorption;
    case OpticalModel::Emission:
      return vtkIlluminatedVolumeMapper::Emission;
    case OpticalModel::AbsorptionEmission:
      return vtkIlluminatedVolumeMapper::AbsorptionEmission;
    default:
      return vtkIlluminatedVolumeMapper::SingleScattering;
  }
}

int ShadowTechniqueOf(TechniqueChoice choice)
{
  switch (choice)
  {
    case TechniqueChoice::Rays:
      return vtkIlluminatedVolumeMapper::Rays;
    case TechniqueChoice::Volume:
      return vtkIlluminatedVolumeMapper::Volume;
    case TechniqueChoice::Map:
      return vtkIlluminatedVolumeMapper::Map;
    case TechniqueChoice::DeepMap:
      return vtkIlluminatedVolumeMapper::DeepMap;
    case TechniqueChoice::OpacityMap:
      return vtkIlluminatedVolumeMapper::OpacityMap;
    default:
      return vtkIlluminatedVolumeMapper::Auto;
  }
}

// What the stock mapper takes for what it does not have.
void TellReplacements(const SceneDescription& scene, std::vector<std::string>& warnings)
{
  const bool shaded = scene.Optics == OpticalModel::SingleScattering;
  if (shaded && scene.Material.Model != ReflectionModel::Phong)
  {
    warnings.push_back("the stock mapper has no other reflection model than phong, which it takes");
  }
  if (shaded && scene.Gradient != GradientEstimator::CentralDifferences)
  {
    warnings.push_back("the stock mapper has no other gradients than central ones, which it takes");
  }
  if (!shaded && scene.Optics != OpticalModel::AbsorptionEmission)
  {
    warnings.push_back("the stock mapper renders absorption and emission instead");
  }
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
void SetStockScattering(
  const SceneDescription& scene, vtkGPUVolumeRayCastMapper* mapper, std::vector<std::string>&)
{
  mapper->SetVolumetricScatteringBlending(static_cast<float>(scene.StockScattering));
  // Shadows of all that lies before a light, not of what is near alone.
  mapper->SetGlobalIlluminationReach(1.0f);
}
#else
void SetStockScattering(
  const SceneDescription& scene, vtkGPUVolumeRayCastMapper*, std::vector<std::string>& warnings)
{
  if (scene.StockScattering > 0.0)
  {
    warnings.push_back("the stock mapper of VTK " VTK_VERSION
                       " has no scattering and does without; VTK 9.2 or later has");
  }
}
#endif

vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeEmptyMapper(RendererChoice renderer)
{
  if (renderer == RendererChoice::StockMapper)
  {
    return vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  }
  return vtkSmartPointer<vtkIlluminatedVolumeMapper>::New();
}

void ApplyIllumination(const SceneDescription& scene, vtkIlluminatedVolumeMapper* mapper)
{
  mapper->SetShadowTechnique(ShadowTechniqueOf(scene.Shadows.Technique));
  mapper->SetShadowTolerance(scene.Shadows.Tolerance);
  mapper->SetShadowResolution(scene.Shadows.Resolution);
  mapper->SetShadowNearSteps(static_cast<int>(scene.Shadows.NearSteps));
  mapper->SetShadowSampleDistance(*scene.Shadows.SampleDistance);
  mapper->SetGradientEstimator(static_cast<int>(scene.Gradient));
  mapper->SetGradientTextureBits(
    scene.GradientTexture.value_or(vtkIlluminatedVolumeMapper::AutomaticGradientTexture));
  mapper->SetSkipEmptySpace(scene.SkipEmptySpace);
  mapper->SetOpticalModel(OpticalModelOf(scene.Optics));
}

void SetCropping(vtkVolumeMapper* mapper, const std::optional<std::array<double, 6>>& cropping)
{
  mapper->SetCropping(cropping.has_value());
  if (cropping)
  {
    mapper->SetCroppingRegionFlagsToSubVolume();
    mapper->SetCroppingRegionPlanes(cropping->data());
  }
}

void SetClippingPlanes(
  const SceneDescription& scene, vtkVolumeMapper* mapper, std::vector<std::string>& warnings)
{
  std::size_t count = scene.ClippingPlanes.size();
  if (scene.Renderer == RendererChoice::StockMapper && count > MostPlanesOfStockMapper)
  {
    count = MostPlanesOfStockMapper;
    warnings.push_back("the stock mapper takes " + std::to_string(count) +
      " clipping planes; the other " + std::to_string(scene.ClippingPlanes.size() - count) +
      " are left out");
  }
  mapper->RemoveAllClippingPlanes();
  for (std::size_t i = 0; i < count; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(scene.ClippingPlanes[i].Origin.data());
    plane->SetNormal(UnitVector(scene.ClippingPlanes[i].Normal).data());
    mapper->AddClippingPlane(plane);
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeMapper(
  const SceneDescription& scene, const SceneVoxels& voxels, std::vector<std::string>& warnings)
{
  auto mapper = MakeEmptyMapper(scene.Renderer);
  mapper->SetInputData(voxels.Volume);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->UseJitteringOff();
  if (voxels.Mask)
  {
    mapper->SetMaskInput(voxels.Mask);
    mapper->SetMaskTypeToBinary();
  }
  ApplyToMapper(scene, mapper, warnings);
  return mapper;
}

//------------------------------------------------------------------------------
void ApplyToMapper(const SceneDescription& scene, vtkGPUVolumeRayCastMapper* mapper,
  std::vector<std::string>& warnings)
{
  mapper->SetSampleDistance(static_cast<float>(*scene.SampleDistance));
  SetCropping(mapper, scene.Volume.Cropping);
  SetClippingPlanes(scene, mapper, warnings);
  if (auto* const illuminated = vtkIlluminatedVolumeMapper::SafeDownCast(mapper))
  {
    ApplyIllumination(scene, illuminated);
  }
  if (scene.Renderer == RendererChoice::StockMapper)
  {
    SetStockScattering(scene, mapper, warnings);
    TellReplacements(scene, warnings);
  }
}

}
