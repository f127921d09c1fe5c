#include "SceneMaterial.h"

#include "EnvironmentMap.h"
#include "InputError.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeMaterial.h>

#include <tuple>

namespace penumbra
{
namespace
{
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

void SetMaterial(const MaterialDescription& description, vtkVolumeMaterial* material)
{
  material->SetReflectionModel(static_cast<int>(description.Model));
  material->SetAmbient(description.Ambient);
  material->SetDiffuse(description.Diffuse);
  material->SetSpecular(description.Specular);
  material->SetSpecularPower(description.SpecularPower);
  material->SetRoughness(description.Roughness);
  material->SetRoughnessX(description.RoughnessX);
  material->SetRoughnessY(description.RoughnessY);
  material->SetPreferredDirection(description.PreferredDirection.data());
  material->SetSlope(description.Slope);
  material->SetDistribution(description.Distribution == FacetDistribution::Gaussian
      ? vtkVolumeMaterial::Gaussian
      : vtkVolumeMaterial::Beckmann);
  material->SetGaussianConstant(description.GaussianConstant);
  material->SetIndexOfRefraction(description.IndexOfRefraction.data());
  material->SetNoiseFading(description.NoiseFading);
}

vtkSmartPointer<vtkImageData> ReadImage(const std::filesystem::path& file)
{
  const std::string name = file.u8string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
  {
    throw InputError("material.environmentMap: there is no file " + name);
  }
  const auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(name.c_str()));
  if (!reader)
  {
    throw InputError("material.environmentMap: " + name +
      " is no image that is known; accepted: PNG, JPEG, TIFF, HDR and what else VTK reads");
  }
  reader->SetFileName(name.c_str());
  reader->Update();
  return reader->GetOutput();
}

void CheckEnvironment(const EnvironmentImages& images)
{
  std::string reason;
  if (!MakeEnvironmentMap({ images.begin(), images.end() }, reason))
  {
    throw InputError("material.environmentMap: " + reason);
  }
}
}

//------------------------------------------------------------------------------
EnvironmentImages ReadEnvironmentImages(const MaterialDescription& material)
{
  EnvironmentImages images;
  if (material.Model == ReflectionModel::ReflectionMap)
  {
    for (const auto& file : material.EnvironmentMap)
    {
      images.push_back(ReadImage(file));
    }
    CheckEnvironment(images);
  }
  return images;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeMaterial> MakeVolumeMaterial(
  const SceneDescription& scene, const EnvironmentImages& environment)
{
  auto material = vtkSmartPointer<vtkVolumeMaterial>::New();
  material->SetInterpolationTypeToLinear();
  const TransferFunctionDescription& function = scene.TransferFunction;
  material->SetScalarOpacity(MakeFunction(*function.Opacity));
  material->SetColor(MakeColorFunction(*function.Color));
  material->SetScalarOpacityUnitDistance(*function.OpacityUnitDistance);
  if (function.GradientOpacity)
  {
    material->SetGradientOpacity(MakeFunction(*function.GradientOpacity));
  }
  material->SetShade(scene.Optics == OpticalModel::SingleScattering);
  SetMaterial(scene.Material, material);
  material->SetEnvironmentMap(environment);
  return material;
}

//------------------------------------------------------------------------------
bool HaveSameMaterial(const SceneDescription& a, const SceneDescription& b)
{
  const auto function = [](const TransferFunctionDescription& f)
  { return std::tie(f.Opacity, f.Color, f.GradientOpacity, f.OpacityUnitDistance); };
  const auto material = [](const MaterialDescription& m)
  {
    return std::tie(m.Model, m.Ambient, m.Diffuse, m.Specular, m.SpecularPower, m.Roughness,
      m.RoughnessX, m.RoughnessY, m.PreferredDirection, m.Slope, m.Distribution, m.GaussianConstant,
      m.IndexOfRefraction, m.EnvironmentMap, m.NoiseFading);
  };
  return a.Optics == b.Optics && function(a.TransferFunction) == function(b.TransferFunction) &&
    material(a.Material) == material(b.Material);
}

}
