#include "ModelAlbedo.h"

#include "ReflectionAlbedo.h"

#include <vtkMath.h>

#include <cmath>

namespace
{
using Model = float (*)(shader::ReflectionCosines, shader::vec4);

shader::vec4 Parameters(double x, double y = 0.0)
{
  return { static_cast<float>(x), static_cast<float>(y), 0.0f, 0.0f };
}

Reflection Reflected(Model model, const shader::vec4& parameters)
{
  return [=](const shader::ReflectionCosines& cosines) { return model(cosines, parameters); };
}

// Near the slope of its half vectors where Blinn and Phong's lobe has fallen to 1/e.
double SlopeOf(double power)
{
  return std::sqrt(2.0 / (power + 2.0));
}

double AnisotropicAlbedo(double x, double y, const Vector& view, int points)
{
  return HalfVectorIntegral(
    Reflected(shader::wardAnisotropic::specularReflection, Parameters(x, y)), view,
    std::sqrt(x * y), points);
}
}

//------------------------------------------------------------------------------
shader::vec4 OrenNayarParameters(double roughness)
{
  const double variance = roughness * roughness;
  return Parameters(1.0 - 0.5 * variance / (variance + 0.33), 0.45 * variance / (variance + 0.09));
}

double OrenNayarAlbedo(double roughness, double degrees, int points)
{
  return HemisphereIntegral(
           Reflected(shader::orenNayar::diffuseReflection, OrenNayarParameters(roughness)),
           AtAngles(degrees), points) /
    vtkMath::Pi();
}

double PhongAlbedo(double power, double degrees, int points)
{
  return MirrorIntegral(Reflected(shader::phong::specularReflection, Parameters(power)),
           AtAngles(degrees), power, points) /
    vtkMath::Pi();
}

double BlinnPhongAlbedo(double power, double degrees, int points)
{
  return HalfVectorIntegral(Reflected(shader::blinnPhong::specularReflection, Parameters(power)),
           AtAngles(degrees), SlopeOf(power), points) /
    vtkMath::Pi();
}

double WardAlbedo(double roughness, double degrees, int points)
{
  return HalfVectorIntegral(Reflected(shader::ward::specularReflection, Parameters(roughness)),
    AtAngles(degrees), roughness, points);
}

double WardAlbedoAlong(double x, double y, double degrees, int points)
{
  return AnisotropicAlbedo(x, y, AtAngles(degrees), points);
}

double WardAlbedoAcross(double x, double y, double degrees, int points)
{
  return AnisotropicAlbedo(x, y, AtAngles(degrees, 90.0), points);
}

double BeckmannAlbedo(double slope, double n, double degrees, int points)
{
  const Reflection facets =
    Reflected(shader::cookTorrance::specularReflection, Parameters(slope, -1.0));
  const auto index = static_cast<float>(n);
  return HalfVectorIntegral(
    [=](const shader::ReflectionCosines& cosines)
    {
      const float vDotH = std::sqrt(0.5f + 0.5f * cosines.lDotV);
      return facets(cosines) * (n > 0.0 ? shader::fresnelReflectance(vDotH, index) : 1.0f);
    },
    AtAngles(degrees), slope, points);
}

double GaussianAlbedo(double slope, double constant, double degrees, int points)
{
  return HalfVectorIntegral(
    Reflected(shader::cookTorrance::specularReflection, Parameters(slope, constant)),
    AtAngles(degrees), slope, points);
}

//------------------------------------------------------------------------------
const std::vector<AlbedoTable>& AlbedoTables()
{
  using Numbers = std::vector<double>;
  static const std::vector<AlbedoTable> tables = {
    { "Phong: n", [](const Numbers& p, double a, int n) { return PhongAlbedo(p.at(0), a, n); } },
    { "Blinn-Phong: n",
      [](const Numbers& p, double a, int n) { return BlinnPhongAlbedo(p.at(0), a, n); } },
    { "Oren-Nayar: s",
      [](const Numbers& p, double a, int n) { return OrenNayarAlbedo(p.at(0), a, n); } },
    { "Ward: s", [](const Numbers& p, double a, int n) { return WardAlbedo(p.at(0), a, n); } },
    { "Ward anisotropic, seen along P: sx, sy",
      [](const Numbers& p, double a, int n) { return WardAlbedoAlong(p.at(0), p.at(1), a, n); } },
    { "Ward anisotropic, seen across P: sx, sy",
      [](const Numbers& p, double a, int n) { return WardAlbedoAcross(p.at(0), p.at(1), a, n); } },
    { "Cook-Torrance, F = 1: m",
      [](const Numbers& p, double a, int n) { return BeckmannAlbedo(p.at(0), 0.0, a, n); } },
    { "Cook-Torrance, n = 1.5: m",
      [](const Numbers& p, double a, int n) { return BeckmannAlbedo(p.at(0), 1.5, a, n); } },
    { "Cook-Torrance, Gaussian, k = 1, F = 1: m",
      [](const Numbers& p, double a, int n) { return GaussianAlbedo(p.at(0), 1.0, a, n); } },
  };
  return tables;
}
