/**
 * @file    Illumination.h
 * @brief   the shaded colour c of a sample of matter
 */

#ifndef Illumination_h
#define Illumination_h

#include "EnvironmentReflection.h"
#include "LightSource.h"
#include "ReflectionFormula.h"
#include "VolumeMatter.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra::reference
{

struct MatterSample
{
  /// In voxel indices.
  vtkVector3d Position;
  /// In scalar units per voxel.
  vtkVector3d Gradient;
  /// Of the transfer function.
  Rgb Color{};
  /// In the world, of unit length.
  vtkVector3d ToEye;
};

struct ShadedSample
{
  /// Clamped to [0, 1].
  Rgb Color{};
  /// Bound on the error of each channel, from the shadows.
  double Error = 0.0;
  /// For each light with a hard shadow by how much the optical depth towards it exceeds what makes
  /// the shadow: where this changes its sign the colour jumps. NaN where the light does not matter.
  std::vector<double> ShadowMargins;
  int ShadowRays = 0;
};

class Illumination
{
public:
  /// `tolerance` is of a shaded colour.
  Illumination(const ReferenceScene& scene, const VolumeMatter& matter, double tolerance);

  ShadedSample Shade(const MatterSample& sample) const;

  /// Why the environment map cannot be used; empty where it can or is not needed.
  std::string GetEnvironmentFault() const;

  int GetNumberOfHardShadows() const { return this->HardShadows; }

  /// Appends where along the span a normal turns its side to a light or to the eye, or a cone of
  /// light ends. `toEye` is in voxel indices.
  void AppendBreaks(const CellSpan& span, const SpanGradient& gradient, const vtkVector3d& toEye,
    std::vector<double>& breaks) const;

private:
  void AddLights(const MatterSample& sample, const vtkVector3d& normal, double directional,
    ShadedSample& shaded) const;
  void AddLight(const LightSource& light, const MatterSample& sample, const vtkVector3d& normal,
    double directional, ShadedSample& shaded) const;
  void AddEnvironment(const MatterSample& sample, const vtkVector3d& normal, double directional,
    ShadedSample& shaded) const;
  Rgb Reflect(const LightSource& light, const MatterSample& sample, vtkVector3d normal,
    const vtkVector3d& toLight, double directional) const;
  double GetDirectionalShare(const vtkVector3d& gradient) const;

  const VolumeMatter& Matter;
  double Tolerance;
  bool TwoSided;
  double Ambient;
  double Diffuse;
  double Specular;
  Rgb AmbientLight;
  std::vector<LightSource> Lights;
  int HardShadows = 0;
  ReflectionFormula Formula;
  std::optional<EnvironmentReflection> Environment;
  vtkVector3d Preferred;
  /// Of the gradient in the volume's own frame; 0: it does not fade.
  double FadingGradient = 0.0;
};

}

#endif
