#include "ReflectionFormula.h"

#include "vtkMath.h"
#include "vtkVectorOperators.h"
#include "vtkVolumeMaterial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra::reference
{
namespace
{
// vtkVolumeMaterial's limits.
constexpr double LeastRoughness = 0.001;
constexpr double DegreesWithoutProjection = 1.0;

double Square(double x)
{
  return x * x;
}

/// What overflows counts as bright, what has no value as none.
double MakeFinite(double value)
{
  constexpr double most = 1e100;
  return std::isnan(value) ? 0.0 : std::min(value, most);
}

/// Of unpolarized light; `cosine` is that of the angle to the facet's normal.
double GetFresnel(double indexOfRefraction, double cosine)
{
  const double c = cosine;
  const double index = std::min(indexOfRefraction, 1e50);
  const double squared = index * index - 1.0 + c * c;
  if (squared < 0.0)
  {
    return 1.0;
  }
  const double g = std::sqrt(squared);
  const double reflectance =
    0.5 * Square((g - c) / (g + c)) * (1.0 + Square((c * (g + c) - 1.0) / (c * (g - c) + 1.0)));
  return std::clamp(MakeFinite(reflectance), 0.0, 1.0);
}
}

//------------------------------------------------------------------------------
ReflectionFormula::ReflectionFormula(vtkVolumeProperty* property)
  : Model(ReflectionModel::Phong)
  , Power(property->GetSpecularPower())
{
  auto* material = vtkVolumeMaterial::SafeDownCast(property);
  if (!material)
  {
    return;
  }
  this->Model = static_cast<ReflectionModel>(material->GetReflectionModel());
  this->Roughness = material->GetRoughness();
  this->RoughnessX = std::max(material->GetRoughnessX(), LeastRoughness);
  this->RoughnessY = std::max(material->GetRoughnessY(), LeastRoughness);
  this->Slope = std::max(material->GetSlope(), LeastRoughness);
  this->IsGaussian = material->GetDistribution() == vtkVolumeMaterial::Gaussian;
  this->GaussianConstant = material->GetGaussianConstant();
  std::copy_n(material->GetIndexOfRefraction(), 3, this->IndexOfRefraction.begin());
  if (this->Model == ReflectionModel::Ward)
  {
    this->RoughnessX = this->RoughnessY = std::max(this->Roughness, LeastRoughness);
  }
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetPhong(const ReflectionDirections& d) const
{
  const vtkVector3d mirrored = d.Normal * (2.0 * d.Normal.Dot(d.ToLight)) - d.ToLight;
  const double cosine = mirrored.Dot(d.ToEye);
  return cosine > 0.0 ? std::pow(std::min(cosine, 1.0), this->Power) : 0.0;
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetOrenNayar(const ReflectionDirections& d) const
{
  const double ofLight = d.Normal.Dot(d.ToLight);
  const double ofEye = std::max(d.Normal.Dot(d.ToEye), 0.0);
  const vtkVector3d light = d.ToLight - d.Normal * ofLight;
  const vtkVector3d eye = d.ToEye - d.Normal * d.Normal.Dot(d.ToEye);
  const double lengths = light.Norm() * eye.Norm();
  const double cosineOfAzimuths = lengths > 0.0 ? light.Dot(eye) / lengths : 0.0;
  const double larger = std::acos(std::clamp(std::min(ofLight, ofEye), 0.0, 1.0));
  const double smaller = std::acos(std::clamp(std::max(ofLight, ofEye), 0.0, 1.0));
  const double inverseVariance = 1.0 / Square(this->Roughness);
  const double a = 1.0 - 0.5 / (1.0 + 0.33 * inverseVariance);
  const double b = 0.45 / (1.0 + 0.09 * inverseVariance);
  return ofLight * (a + b * std::max(cosineOfAzimuths, 0.0) * std::sin(larger) * std::tan(smaller));
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetWardExponent(
  const ReflectionDirections& d, const vtkVector3d& half) const
{
  const double cosine = d.Normal.Dot(half);
  const double isotropic =
    d.Normal.Cross(half).SquaredNorm() / (Square(cosine) * this->RoughnessX * this->RoughnessY);
  const vtkVector3d projection = d.Preferred - d.Normal * d.Normal.Dot(d.Preferred);
  const double squaredSine = projection.SquaredNorm();
  if (squaredSine == 0.0)
  {
    return isotropic;
  }
  const vtkVector3d along = projection * (1.0 / std::sqrt(squaredSine));
  const vtkVector3d across = d.Normal.Cross(along);
  const double anisotropic =
    (Square(half.Dot(along) / this->RoughnessX) + Square(half.Dot(across) / this->RoughnessY)) /
    Square(cosine);
  const double enough = Square(std::sin(vtkMath::RadiansFromDegrees(DegreesWithoutProjection)));
  const double share = std::min(squaredSine / enough, 1.0);
  return share * anisotropic + (1.0 - share) * isotropic;
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetWard(const ReflectionDirections& d, const vtkVector3d& half) const
{
  return std::sqrt(MakeFinite(d.Normal.Dot(d.ToLight) / d.Normal.Dot(d.ToEye))) *
    std::exp(-this->GetWardExponent(d, half)) /
    (4.0 * vtkMath::Pi() * this->RoughnessX * this->RoughnessY);
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetFacets(double cosine, double sine) const
{
  if (this->IsGaussian)
  {
    const double angle = std::atan2(sine, cosine);
    return this->GaussianConstant * std::exp(-Square(angle / this->Slope));
  }
  const double exponent = Square(sine / cosine / this->Slope);
  constexpr double vanishing = 700.0;
  return exponent < vanishing ? std::exp(-exponent) / (Square(this->Slope) * Square(Square(cosine)))
                              : 0.0;
}

//------------------------------------------------------------------------------
double ReflectionFormula::GetCookTorrance(
  const ReflectionDirections& d, const vtkVector3d& half) const
{
  const double ofHalf = d.Normal.Dot(half);
  const double ofEye = d.Normal.Dot(d.ToEye);
  const double masking = 2.0 * ofHalf / d.ToEye.Dot(half);
  const double geometry = std::min({ 1.0, masking * ofEye, masking * d.Normal.Dot(d.ToLight) });
  return this->GetFacets(ofHalf, d.Normal.Cross(half).Norm()) * geometry / (vtkMath::Pi() * ofEye);
}

//------------------------------------------------------------------------------
Reflected ReflectionFormula::Evaluate(const ReflectionDirections& d) const
{
  Reflected reflected;
  const double ofLight = d.Normal.Dot(d.ToLight);
  if (!(ofLight > 0.0))
  {
    return reflected;
  }
  reflected.Diffuse = this->Model == ReflectionModel::OrenNayar ? this->GetOrenNayar(d) : ofLight;
  if (this->Model == ReflectionModel::Phong)
  {
    reflected.Specular.fill(this->GetPhong(d));
    return reflected;
  }
  const vtkVector3d sum = d.ToLight + d.ToEye;
  if (d.Normal.Dot(d.ToEye) <= 0.0 || sum.Norm() == 0.0)
  {
    return reflected;
  }
  const vtkVector3d half = sum.Normalized();
  switch (this->Model)
  {
    case ReflectionModel::BlinnPhong:
      reflected.Specular.fill(std::pow(std::clamp(d.Normal.Dot(half), 0.0, 1.0), this->Power));
      break;
    case ReflectionModel::Ward:
    case ReflectionModel::WardAnisotropic:
      reflected.Specular.fill(MakeFinite(this->GetWard(d, half)));
      break;
    case ReflectionModel::CookTorrance:
      for (int channel = 0; channel < 3; ++channel)
      {
        reflected.Specular[channel] =
          GetFresnel(this->IndexOfRefraction[channel], d.ToEye.Dot(half)) *
          MakeFinite(this->GetCookTorrance(d, half));
      }
      break;
    default:
      break;
  }
  return reflected;
}

}
