#include "SceneOptions.h"

#include "MakeLight.h"
#include "SyntheticVolumes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkVolumeMaterial.h>

#include <algorithm>

namespace penumbra
{
namespace
{
const VolumeGrid grid = { { 12, 12, 24 } };
const Point ballCenter = { 5.5, 5.5, 5.5 };

vtkSmartPointer<vtkImageData> MakeBallBeforeEmptySpace()
{
  return SampleField(grid,
    [](const Point& position)
    {
      const double depth = 5.0 - Distance(position, ballCenter);
      return 255.0 * std::clamp(depth / 4.0 + 0.5, 0.0, 1.0);
    });
}

void SetLights(IlluminatedScene& scene, const SceneOptions& options)
{
  scene.Renderer->RemoveAllLights();
  for (int kind = 0; kind < NumberOfLightKinds; ++kind)
  {
    for (int shadow = 0; shadow < NumberOfShadowKinds; ++shadow)
    {
      for (int count = 0; count < options.lights[kind][shadow]; ++count)
      {
        const auto light = MakeLight(static_cast<LightKind>(kind), static_cast<ShadowKind>(shadow));
        light->SetIntensity(0.2);
        if (options.attenuation)
        {
          light->SetAttenuationValues(1.0, 0.01, 0.0001);
        }
        scene.Renderer->AddLight(light);
      }
    }
  }
}

void SetTransferFunctions(IlluminatedScene& scene, const SceneOptions& options)
{
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AllowDuplicateScalarsOn();
  scene.Opacity->AddPoint(options.steep ? 149.0 : 50.0, 0.0);
  scene.Opacity->AddPoint(150.0, 0.3);
  if (options.opacity == TransferFunctionLookup::Points)
  {
    scene.Opacity->AddPoint(150.0, 0.4);
  }
  scene.Opacity->AddPoint(255.0, 0.5);
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  gradientOpacity->AddPoint(0.0, 0.3);
  gradientOpacity->AddPoint(60.0, 1.0);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetGradientOpacity(gradientOpacity);
  property->SetDisableGradientOpacity(!options.gradientOpacity);
}

vtkSmartPointer<vtkImageData> MakeGraySurroundings()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(128.0);
  return image;
}

// Each cuts off a corner or an edge of the volume, none its middle.
void SetClippingPlanes(IlluminatedScene& scene, int count)
{
  scene.Mapper->RemoveAllClippingPlanes();
  for (int i = 0; i < count; ++i)
  {
    const double sign = i < 3 ? 1.0 : -1.0;
    double normal[3] = { 0.3, 0.3, 0.3 };
    normal[i % 3] = 1.0;
    vtkNew<vtkPlane> plane;
    plane->SetNormal(sign * normal[0], sign * normal[1], sign * normal[2]);
    plane->SetOrigin(
      5.5 - 3.0 * sign * normal[0], 5.5 - 3.0 * sign * normal[1], 5.5 - 3.0 * sign * normal[2]);
    scene.Mapper->AddClippingPlane(plane);
  }
}

void SetCropping(IlluminatedScene& scene, CroppingKind cropping)
{
  scene.Mapper->SetCropping(cropping != CroppingKind::None);
  scene.Mapper->SetCroppingRegionPlanes(2.3, 9.7, 1.6, 8.2, 2.0, 11.0);
  scene.Mapper->SetCroppingRegionFlags(
    cropping == CroppingKind::Box ? VTK_CROP_SUBVOLUME : VTK_CROP_FENCE);
}

void SetOptics(IlluminatedScene& scene, OpticalModel optics)
{
  const bool unusual = optics == OpticalModel::Absorption || optics == OpticalModel::Emission;
  scene.Volume->GetProperty()->SetShade(optics == OpticalModel::SingleScattering);
  scene.Mapper->SetOpticalModel(unusual
      ? vtkIlluminatedVolumeMapper::Absorption + static_cast<int>(optics)
      : vtkIlluminatedVolumeMapper::ByShade);
}

void SetMaterial(vtkVolumeMaterial* material, const SceneOptions& options)
{
  material->SetReflectionModel(static_cast<int>(options.reflection));
  material->SetNoiseFading(options.noiseFading ? 1.0 : 0.0);
  material->SetEnvironmentMap(
    options.reflection == ReflectionModel::ReflectionMap ? MakeGraySurroundings() : nullptr);
}

vtkSmartPointer<vtkImageData> MakeMask()
{
  return MakeSlab(grid, 2, 1.0, 8.0);
}
}

//------------------------------------------------------------------------------
LightingRequirements SceneOptions::Expected() const
{
  LightingRequirements needs;
  needs.GradientOpacity = this->gradientOpacity;
  needs.ClippingPlanes = this->clippingPlanes;
  needs.Cropping = this->cropping;
  needs.Mask = this->mask;
  needs.Opacity = this->opacity;
  needs.PreIntegrated = this->steep && this->opacity == TransferFunctionLookup::Table &&
    !this->mask && this->cropping != CroppingKind::Regions;
  needs.EmptySpaceSkipping = this->emptySpace;
  needs.Optics = this->optics;
  if (needs.IsShaded())
  {
    this->ExpectReflection(needs);
  }
  needs.HalvedSteps = needs.NeedsNormal() && this->halvedSteps;
  if (needs.NeedsGradient())
  {
    needs.Gradient = this->gradient;
    needs.GradientTexture = this->gradientTexture;
  }
  return needs;
}

//------------------------------------------------------------------------------
void SceneOptions::ExpectReflection(LightingRequirements& needs) const
{
  const bool shines = this->specular && this->reflection != ReflectionModel::OrenNayar;
  const bool mirrors = this->reflection == ReflectionModel::ReflectionMap;
  if ((this->diffuse || shines) && !mirrors)
  {
    needs.Lights = this->lights;
  }
  if (needs.GetNumberOfShadowedLights() > 0)
  {
    needs.Technique = this->technique;
    const int nearSteps = this->technique != ShadowTechnique::Rays ? this->nearShadowSteps : 0;
    needs.NearShadowRays = nearSteps > 8;
    needs.NearShadowSteps = needs.NearShadowRays ? 0 : nearSteps;
  }
  const bool lit = needs.GetNumberOfLights() > 0;
  needs.Diffuse = (lit || mirrors) && this->diffuse;
  needs.Specular = (lit || mirrors) && shines;
  needs.TwoSidedLighting = lit && this->twoSided;
  needs.Attenuation = this->attenuation &&
    needs.GetNumberOfLights(LightKind::Point) + needs.GetNumberOfLights(LightKind::Spot) > 0;
  if (needs.Diffuse || needs.Specular)
  {
    needs.Reflection = this->reflection;
    needs.NoiseFading = this->noiseFading;
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<IlluminatedScene> MakeScene()
{
  auto scene = std::make_unique<IlluminatedScene>(MakeBallBeforeEmptySpace(), 32, 32);
  scene->LookFrom(0.4, 0.3, 0.85, 36.0, ballCenter.data());
  vtkNew<vtkVolumeMaterial> material;
  material->DeepCopy(scene->Volume->GetProperty());
  material->SetScalarOpacity(scene->Opacity);
  material->SetColor(scene->Color);
  scene->Volume->SetProperty(material);
  return scene;
}

//------------------------------------------------------------------------------
void SetOptions(IlluminatedScene& scene, const SceneOptions& options)
{
  SetMaterial(vtkVolumeMaterial::SafeDownCast(scene.Volume->GetProperty()), options);
  SetOptics(scene, options.optics);
  scene.Mapper->SetSkipEmptySpace(options.emptySpace);
  scene.Mapper->SetShadowTechnique(
    vtkIlluminatedVolumeMapper::Rays + static_cast<int>(options.technique));
  scene.Mapper->SetShadowNearSteps(options.nearShadowSteps);
  scene.Mapper->SetGradientEstimator(static_cast<int>(options.gradient));
  scene.Mapper->SetGradientTextureBits(options.gradientTexture ? 8 : 0);
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetDiffuse(options.diffuse ? 0.7 : 0.0);
  property->SetSpecular(options.specular ? 0.3 : 0.0);
  scene.Renderer->SetTwoSidedLighting(options.twoSided);
  SetLights(scene, options);
  SetTransferFunctions(scene, options);
  SetClippingPlanes(scene, options.clippingPlanes);
  SetCropping(scene, options.cropping);
  scene.Mapper->SetMaskInput(options.mask ? MakeMask() : nullptr);
  scene.Mapper->SetMaskTypeToBinary();
  // Coarse, for these pictures show that something is drawn, not what.
  scene.Mapper->SetSampleDistance(options.halvedSteps ? 0.5f : 1.5f);
  scene.Mapper->SetImageSampleDistance(options.gathering ? 1.5f : 1.0f);
}

}
