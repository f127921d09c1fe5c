#include "EnvironmentReflection.h"

#include "vtkImageData.h"
#include "vtkVolumeMaterial.h"

namespace penumbra::reference
{
namespace
{
// Narrower lobes meet few pixels: then a table costs more than it saves.
constexpr double LargestPowerInTable = 3000.0;

// Lambert's cosine.
constexpr double DiffusePower = 1.0;

EnvironmentMap MakeMap(vtkVolumeMaterial* material, std::string& fault)
{
  const auto& images = material->GetEnvironmentMap();
  const auto map = MakeEnvironmentMap({ images.begin(), images.end() }, fault);
  return map ? *map : EnvironmentMap{ { EnvironmentImage{ 2, 1, std::vector<float>(6) } } };
}
}

//------------------------------------------------------------------------------
EnvironmentReflection::EnvironmentReflection(vtkVolumeMaterial* material, double tolerance)
  : SeenDiffusely(MakeMap(material, this->Fault), LobeIntegral::GetLargestPixel(DiffusePower))
  , SeenSpecularly(
      MakeMap(material, this->Fault), LobeIntegral::GetLargestPixel(material->GetSpecularPower()))
  , Mean(SeenDiffusely.GetMean())
  , Diffuse(LobeIntegral(SeenDiffusely, DiffusePower), tolerance)
  , SpecularLobe(SeenSpecularly, material->GetSpecularPower())
  , Specular(SpecularLobe, tolerance)
{
}

//------------------------------------------------------------------------------
EnvironmentReflection::Result EnvironmentReflection::GetDiffuse(const vtkVector3d& normal) const
{
  return normal.SquaredNorm() > 0.0 ? this->Diffuse.LookUp(normal) : Result{};
}

//------------------------------------------------------------------------------
EnvironmentReflection::Result EnvironmentReflection::GetSpecular(const vtkVector3d& mirrored) const
{
  if (!(mirrored.SquaredNorm() > 0.0))
  {
    return {};
  }
  return this->SpecularLobe.GetPower() > LargestPowerInTable
    ? Result{ this->SpecularLobe.Evaluate(mirrored), 0.0 }
    : this->Specular.LookUp(mirrored);
}

}
