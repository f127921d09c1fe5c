/**
 * @file    ReflectionFormula.h
 * @brief   how much of a light's light matter reflects to the eye
 */

#ifndef ReflectionFormula_h
#define ReflectionFormula_h

#include "LightingRequirements.h" // For ReflectionModel

#include "vtkVector.h"

#include <array>

class vtkVolumeProperty;

namespace penumbra::reference
{

/// F_d and, for red, green and blue, F_s.
struct Reflected
{
  double Diffuse = 0.0;
  std::array<double, 3> Specular{};
};

/// All of unit length.
struct ReflectionDirections
{
  vtkVector3d Normal;
  vtkVector3d ToLight;
  vtkVector3d ToEye;
  /// In which an anisotropic surface is brushed.
  vtkVector3d Preferred;
};

class ReflectionFormula
{
public:
  explicit ReflectionFormula(vtkVolumeProperty* property);

  ReflectionModel GetModel() const { return this->Model; }
  /// Whether it changes abruptly where the eye passes the surface's plane.
  bool DependsOnSideOfEye() const { return this->Model != ReflectionModel::Phong; }

  /// None where the normal points away from the light.
  Reflected Evaluate(const ReflectionDirections& directions) const;

private:
  double GetPhong(const ReflectionDirections& directions) const;
  double GetOrenNayar(const ReflectionDirections& directions) const;
  double GetWard(const ReflectionDirections& directions, const vtkVector3d& half) const;
  double GetWardExponent(const ReflectionDirections& directions, const vtkVector3d& half) const;
  double GetFacets(double cosine, double sine) const;
  double GetCookTorrance(const ReflectionDirections& directions, const vtkVector3d& half) const;

  ReflectionModel Model;
  double Power;
  double Roughness = 0.3;
  double RoughnessX = 0.1;
  double RoughnessY = 0.5;
  double Slope = 0.3;
  bool IsGaussian = false;
  double GaussianConstant = 1.0;
  std::array<double, 3> IndexOfRefraction{};
};

}

#endif
