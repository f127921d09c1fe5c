/**
 * @file    LightSource.h
 * @brief   the lights of a scene as they shine in the world
 */

#ifndef LightSource_h
#define LightSource_h

#include "LightingRequirements.h" // For ShadowKind

#include "vtkVector.h"

#include <array>
#include <vector>

namespace penumbra
{
struct ReferenceScene;
}

namespace penumbra::reference
{

using Rgb = std::array<double, 3>;

struct LightSource
{
  /// False: it shines along Axis everywhere.
  bool HasPosition = false;
  vtkVector3d Position;
  /// The way the light travels, of unit length, or 0 where the light says none.
  vtkVector3d Axis;
  /// Colours times intensity.
  Rgb Diffuse{};
  Rgb Specular{};
  std::array<double, 3> Attenuation{};
  bool HasCone = false;
  double CosineOfCone = -1.0;
  double Exponent = 1.0;
  ShadowKind Shadow = ShadowKind::None;
  /// Its number among the lights with hard shadows, or -1.
  int HardShadow = -1;
  /// Optical depth beyond which a hard shadow is complete.
  double LargestDepth = 0.0;
  /// In the volume's own frame.
  double Bias = 0.0;

  /// min(1 / (c1 + c2 d + c3 d^2), 1) at this distance.
  double GetAttenuation(double distance) const;
  /// Of the cone, in the direction in which light travels to the sample.
  double GetSpot(const vtkVector3d& direction) const;
};

/// Those that are on, and not black.
std::vector<LightSource> MakeLightSources(const ReferenceScene& scene, double smallestSpacing);

/// The sum over the lights that are on; white where they are all plain lights that say black.
Rgb GetAmbientLight(const ReferenceScene& scene);

}

#endif
