#include "Catch.h"
#include "LightsAndMaterial.h"
#include "MakeLight.h"
#include "vtkVolumeMaterial.h"

#include <vtkImageData.h>

#include <sstream>

using namespace penumbra;

namespace
{
void SetEverything(vtkVolumeMaterial* material)
{
  material->SetAmbient(0.3);
  material->SetReflectionModelToCookTorrance();
  material->SetRoughness(0.4);
  material->SetRoughnessX(0.2);
  material->SetRoughnessY(0.6);
  material->SetPreferredDirection(0.0, 1.0, 2.0);
  material->SetSlope(0.7);
  material->SetDistributionToGaussian();
  material->SetGaussianConstant(3.0);
  material->SetIndexOfRefraction(1.25, 1.5, 1.75);
  material->SetNoiseFading(2.0);
  vtkNew<vtkImageData> image;
  material->SetEnvironmentMap(image);
}

std::string Print(vtkVolumeMaterial* material)
{
  std::ostringstream text;
  material->Print(text);
  const std::string whole = text.str();
  return whole.substr(whole.find("ReflectionModel"));
}

// A lit scene whose property is a material.
LightingRequirements RequirementsOf(vtkVolumeMaterial* material, bool environmentMap = false)
{
  const auto light = MakeLight(LightKind::Point, ShadowKind::Soft);
  LightsAndMaterial with({ light });
  material->ShadeOn();
  with.scene.Property = material;
  with.scene.EnvironmentMap = environmentMap;
  return with.Requirements();
}
}

TEST_CASE("A material reflects by Phong's model until it is told otherwise")
{
  vtkNew<vtkVolumeMaterial> material;
  CHECK(material->GetReflectionModel() == vtkVolumeMaterial::Phong);
  CHECK(material->GetNoiseFading() == 0.0);
  CHECK(material->GetEnvironmentMap().empty());
  CHECK(GetReflectionModel(material) == ReflectionModel::Phong);
  vtkNew<vtkVolumeProperty> plain;
  CHECK(GetReflectionModel(plain) == ReflectionModel::Phong);
}

TEST_CASE("A material's models have names, and out of range values are clamped")
{
  vtkNew<vtkVolumeMaterial> material;
  material->SetReflectionModelToWardAnisotropic();
  CHECK(std::string(material->GetReflectionModelAsString()) == "WardAnisotropic");
  material->SetReflectionModel(99);
  CHECK(std::string(material->GetReflectionModelAsString()) == "ReflectionMap");
  material->SetReflectionModel(-1);
  CHECK(std::string(material->GetReflectionModelAsString()) == "Phong");
  material->SetRoughness(-1.0);
  CHECK(material->GetRoughness() == 0.0);
  material->SetNoiseFading(-1.0);
  CHECK(material->GetNoiseFading() == 0.0);
}

TEST_CASE("A deep copy of a material has all of it, and of a plain property what that has")
{
  vtkNew<vtkVolumeMaterial> material;
  SetEverything(material);
  vtkNew<vtkVolumeMaterial> copy;
  copy->DeepCopy(material);
  CHECK(Print(copy) == Print(material));
  CHECK(copy->GetEnvironmentMap() == material->GetEnvironmentMap());
  CHECK(copy->GetAmbient() == 0.3);
  vtkNew<vtkVolumeProperty> plain;
  plain->SetAmbient(0.8);
  copy->DeepCopy(plain);
  CHECK(copy->GetAmbient() == 0.8);
  CHECK(copy->GetReflectionModel() == vtkVolumeMaterial::CookTorrance);
}

TEST_CASE("A material is modified by its setters and by its environment's pixels")
{
  vtkNew<vtkVolumeMaterial> material;
  vtkNew<vtkImageData> image;
  material->SetEnvironmentMap(image);
  const auto before = material->GetMTime();
  material->SetEnvironmentMap(image);
  CHECK(material->GetMTime() == before);
  image->Modified();
  CHECK(material->GetMTime() > before);
  const auto after = material->GetMTime();
  material->SetSlope(0.1);
  CHECK(material->GetMTime() > after);
  material->SetEnvironmentMap(nullptr);
  CHECK(material->GetEnvironmentMap().empty());
}

TEST_CASE("A scene needs its material's model, and only the terms that it has")
{
  vtkNew<vtkVolumeMaterial> material;
  material->SetDiffuse(0.7);
  material->SetSpecular(0.3);
  material->SetReflectionModelToWard();
  CHECK(RequirementsOf(material).Reflection == ReflectionModel::Ward);
  CHECK(RequirementsOf(material).Specular);
  material->SetReflectionModelToOrenNayar();
  CHECK(RequirementsOf(material).Diffuse);
  CHECK_FALSE(RequirementsOf(material).Specular);
  material->SetNoiseFading(1.0);
  CHECK(RequirementsOf(material).NoiseFading);
  // Without any term it is ambient light that is left, whatever the model.
  material->SetDiffuse(0.0);
  CHECK(RequirementsOf(material).GetNumberOfLights() == 0);
  CHECK(RequirementsOf(material).Reflection == ReflectionModel::Phong);
  CHECK_FALSE(RequirementsOf(material).NoiseFading);
}

TEST_CASE("A reflection map takes the lights' place, where there is one")
{
  vtkNew<vtkVolumeMaterial> material;
  material->SetDiffuse(0.7);
  material->SetSpecular(0.0);
  material->SetReflectionModelToReflectionMap();
  const LightingRequirements without = RequirementsOf(material);
  CHECK_FALSE(without.NeedsNormal());
  const LightingRequirements with = RequirementsOf(material, true);
  CHECK(with.NeedsEnvironment());
  CHECK(with.NeedsGradient());
  CHECK(with.Diffuse);
  CHECK_FALSE(with.Specular);
  CHECK_FALSE(with.TwoSidedLighting);
  CHECK(with.GetNumberOfLights() == 0);
}

TEST_CASE("The optical model is the scene's, or else the property's shade")
{
  LightsAndMaterial with;
  CHECK(with.Requirements().Optics == OpticalModel::SingleScattering);
  with.property->ShadeOff();
  CHECK(with.Requirements().Optics == OpticalModel::AbsorptionEmission);
  with.scene.Optics = OpticalModel::Emission;
  CHECK(with.Requirements().Optics == OpticalModel::Emission);
  CHECK_FALSE(with.Requirements().IsShaded());
}
