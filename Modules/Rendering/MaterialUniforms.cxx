#include "MaterialUniforms.h"

#include "LightingRequirements.h"
#include "MatrixUniforms.h"

#include "vtkVolumeMaterial.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr double SmallestRoughness = 0.001;
// Beyond it no lobe changes any more, and its square is still a float.
constexpr double LargestRoughness = 1e6;

double FiniteOr(double value, double otherwise)
{
  return std::isfinite(value) ? value : otherwise;
}

double LobeRoughness(double roughness, double otherwise)
{
  return std::clamp(FiniteOr(roughness, otherwise), SmallestRoughness, LargestRoughness);
}

// A and B of Oren and Nayar's model.
std::array<double, 4> GetOrenNayarParameters(double roughness)
{
  const double variance = std::min(roughness * roughness, 1e12);
  return { 1.0 - 0.5 * variance / (variance + 0.33), 0.45 * variance / (variance + 0.09), 0.0,
    0.0 };
}

std::array<double, 4> GetCookTorranceParameters(vtkVolumeMaterial* material)
{
  constexpr double beckmann = -1.0;
  const double constant = std::clamp(FiniteOr(material->GetGaussianConstant(), 1.0), 0.0, 1e6);
  return { LobeRoughness(material->GetSlope(), 0.3),
    material->GetDistribution() == vtkVolumeMaterial::Gaussian ? constant : beckmann, 0.0, 0.0 };
}

std::array<double, 4> GetReflectionParameters(vtkVolumeMaterial* material)
{
  switch (static_cast<ReflectionModel>(material->GetReflectionModel()))
  {
    case ReflectionModel::OrenNayar:
      return GetOrenNayarParameters(FiniteOr(material->GetRoughness(), 0.3));
    case ReflectionModel::Ward:
      return { LobeRoughness(material->GetRoughness(), 0.3), 0.0, 0.0, 0.0 };
    case ReflectionModel::WardAnisotropic:
      return { LobeRoughness(material->GetRoughnessX(), 0.1),
        LobeRoughness(material->GetRoughnessY(), 0.5), 0.0, 0.0 };
    case ReflectionModel::CookTorrance:
      return GetCookTorranceParameters(material);
    default:
      return { material->GetSpecularPower(0), 0.0, 0.0, 0.0 };
  }
}

Vector3 GetIndexOfRefraction(vtkVolumeMaterial* material)
{
  constexpr double least = 1e-3;
  constexpr double most = 1e6;
  Vector3 index;
  std::transform(material->GetIndexOfRefraction(), material->GetIndexOfRefraction() + 3,
    index.begin(), [=](double n) { return std::clamp(FiniteOr(n, 1.5), least, most); });
  return index;
}

// A tangent of the surface: it turns and is stretched as the matter is.
Vector3 GetPreferredDirection(vtkVolumeMaterial* material, const VolumePlacement& placement)
{
  const double* own = material->GetPreferredDirection();
  Matrix4 ownToTexture;
  const bool usable =
    std::all_of(own, own + 3, [](double component) { return std::isfinite(component); }) &&
    Invert(placement.TextureToOwn, ownToTexture);
  const Vector3 direction = Normalized({ own[0], own[1], own[2] });
  if (!usable || GetLength(direction) == 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  return Normalized(
    MultiplyDirection(placement.TextureToWorld, MultiplyDirection(ownToTexture, direction)));
}
}

//------------------------------------------------------------------------------
MaterialUniforms MakeMaterialUniforms(vtkVolumeProperty* property, const VolumePlacement& placement)
{
  MaterialUniforms uniforms;
  uniforms.Reflection[0] = property->GetSpecularPower(0);
  uniforms.DiffuseFactor = property->GetDiffuse(0);
  uniforms.SpecularFactor = property->GetSpecular(0);
  if (auto* material = vtkVolumeMaterial::SafeDownCast(property))
  {
    uniforms.Reflection = GetReflectionParameters(material);
    uniforms.IndexOfRefraction = GetIndexOfRefraction(material);
    uniforms.PreferredDirection = GetPreferredDirection(material, placement);
  }
  return uniforms;
}

//------------------------------------------------------------------------------
void MaterialUniforms::Set(vtkShaderProgram* program) const
{
  SetUniform(program, "scene_reflection", this->Reflection);
  SetUniform(program, "scene_indexOfRefraction", this->IndexOfRefraction);
  SetUniform(program, "scene_preferredDirection", this->PreferredDirection);
  SetUniform(program, "scene_diffuseFactor", this->DiffuseFactor);
  SetUniform(program, "scene_specularFactor", this->SpecularFactor);
  SetUniform(program, "scene_gradientToNoise", this->GradientToNoise);
  SetUniform(program, "scene_fadedReflection", this->FadedReflection);
}

}
