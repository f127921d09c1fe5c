#include "SceneVolume.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

#include <vtkIlluminatedVolumeMapper.h>

namespace penumbra
{
namespace
{
// VTK 9.1 keeps clipping planes in an array of this many.
constexpr std::size_t MostPlanesOfStockMapper = 8;

vtkSmartPointer<vtkPiecewiseFunction> MakeFunction(const FunctionPoints<1>& points)
{
  auto function = vtkSmartPointer<vtkPiecewiseFunction>::New();
  function->AllowDuplicateScalarsOn(); // two points at one value are a step
  for (const auto& [x, y] : points)
  {
    function->AddPoint(x, y);
  }
  return function;
}

vtkSmartPointer<vtkColorTransferFunction> MakeColorFunction(const FunctionPoints<3>& points)
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->AllowDuplicateScalarsOn();
  for (const auto& [x, red, green, blue] : points)
  {
    function->AddRGBPoint(x, red, green, blue);
  }
  return function;
}

vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeEmptyMapper(const SceneDescription& scene)
{
  if (scene.Renderer == RendererChoice::Penumbra)
  {
    auto mapper = vtkSmartPointer<vtkIlluminatedVolumeMapper>::New();
    mapper->SetShadowTechniqueToRays();
    mapper->SetShadowSampleDistance(*scene.Shadows.SampleDistance);
    return mapper;
  }
  return vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
}

void SetCropping(vtkVolumeMapper* mapper, const std::array<double, 6>& cropping)
{
  mapper->CroppingOn();
  mapper->SetCroppingRegionFlagsToSubVolume();
  mapper->SetCroppingRegionPlanes(cropping.data());
}

void AddClippingPlanes(
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
vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty(const SceneDescription& scene)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetInterpolationTypeToLinear();
  const TransferFunctionDescription& function = scene.TransferFunction;
  property->SetScalarOpacity(MakeFunction(*function.Opacity));
  property->SetColor(MakeColorFunction(*function.Color));
  property->SetScalarOpacityUnitDistance(*function.OpacityUnitDistance);
  if (function.GradientOpacity)
  {
    property->SetGradientOpacity(MakeFunction(*function.GradientOpacity));
  }
  property->SetShade(scene.Shade);
  property->SetAmbient(scene.Material.Ambient);
  property->SetDiffuse(scene.Material.Diffuse);
  property->SetSpecular(scene.Material.Specular);
  property->SetSpecularPower(scene.Material.SpecularPower);
  return property;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkGPUVolumeRayCastMapper> MakeMapper(
  const SceneDescription& scene, const SceneVoxels& voxels, std::vector<std::string>& warnings)
{
  auto mapper = MakeEmptyMapper(scene);
  mapper->SetInputData(voxels.Volume);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->UseJitteringOff();
  mapper->SetSampleDistance(static_cast<float>(*scene.SampleDistance));
  if (scene.Volume.Cropping)
  {
    SetCropping(mapper, *scene.Volume.Cropping);
  }
  if (voxels.Mask)
  {
    mapper->SetMaskInput(voxels.Mask);
    mapper->SetMaskTypeToBinary();
  }
  AddClippingPlanes(scene, mapper, warnings);
  return mapper;
}

}
