#include "vtkVolumeMaterial.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkVolumeMaterial);

//------------------------------------------------------------------------------
vtkVolumeMaterial::vtkVolumeMaterial() = default;

//------------------------------------------------------------------------------
vtkVolumeMaterial::~vtkVolumeMaterial() = default;

//------------------------------------------------------------------------------
const char* vtkVolumeMaterial::GetReflectionModelAsString()
{
  static const char* const names[] = { "Phong", "BlinnPhong", "OrenNayar", "Ward",
    "WardAnisotropic", "CookTorrance", "ReflectionMap" };
  return names[this->ReflectionModel];
}

//------------------------------------------------------------------------------
void vtkVolumeMaterial::SetEnvironmentMap(vtkImageData* equirectangular)
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  if (equirectangular)
  {
    images.emplace_back(equirectangular);
  }
  this->SetEnvironmentMap(images);
}

//------------------------------------------------------------------------------
void vtkVolumeMaterial::SetEnvironmentMap(const std::vector<vtkSmartPointer<vtkImageData>>& images)
{
  if (images != this->EnvironmentMap)
  {
    this->EnvironmentMap = images;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeMaterial::DeepCopy(vtkVolumeProperty* property)
{
  this->Superclass::DeepCopy(property);
  if (auto* material = vtkVolumeMaterial::SafeDownCast(property))
  {
    this->SetReflectionModel(material->ReflectionModel);
    this->SetRoughness(material->Roughness);
    this->SetRoughnessX(material->RoughnessX);
    this->SetRoughnessY(material->RoughnessY);
    this->SetPreferredDirection(material->PreferredDirection);
    this->SetSlope(material->Slope);
    this->SetDistribution(material->Distribution);
    this->SetGaussianConstant(material->GaussianConstant);
    this->SetIndexOfRefraction(material->IndexOfRefraction);
    this->SetEnvironmentMap(material->EnvironmentMap);
    this->SetNoiseFading(material->NoiseFading);
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeMaterial::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const auto& image : this->EnvironmentMap)
  {
    time = image ? std::max(time, image->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkVolumeMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* vector) {
    os << indent << name << ": (" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")\n";
  };
  os << indent << "ReflectionModel: " << this->GetReflectionModelAsString() << "\n";
  os << indent << "Roughness: " << this->Roughness << "\n";
  os << indent << "RoughnessX: " << this->RoughnessX << "\n";
  os << indent << "RoughnessY: " << this->RoughnessY << "\n";
  print("PreferredDirection", this->PreferredDirection);
  os << indent << "Slope: " << this->Slope << "\n";
  os << indent << "Distribution: " << (this->Distribution == Gaussian ? "Gaussian" : "Beckmann")
     << "\n";
  os << indent << "GaussianConstant: " << this->GaussianConstant << "\n";
  print("IndexOfRefraction", this->IndexOfRefraction);
  os << indent << "EnvironmentMap: " << this->EnvironmentMap.size() << " images\n";
  os << indent << "NoiseFading: " << this->NoiseFading << "\n";
}
