/**
 * @file    ShadowingMatter.h
 * @brief   all that decides how much of a light matter lets through, but for the light
 *
 * A plain value: what is kept between pictures of a volume's visibility holds as long as it is
 * equal. Colours, materials and the camera are not in it.
 */

#ifndef ShadowingMatter_h
#define ShadowingMatter_h

#include "LightingRequirements.h"
#include "VolumePlacement.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkVolumeProperty;

namespace penumbra
{

struct DrawnScene;
class VolumeTextures;

struct ShadowingMatter
{
  /// With all that does not concern matter left out.
  LightingRequirements Requirements;
  vtkMTimeType ScalarsTime = 0;
  vtkMTimeType MaskTime = 0;
  bool LinearInterpolation = true;
  int GradientTextureBits = 0;
  /// The points of the opacity and the gradient opacity function, and whether they hold beyond.
  std::vector<double> Opacity;
  std::vector<double> GradientOpacity;
  double UnitDistance = 1.0;
  Matrix4 TextureToOwn{};
  Vector3 BoxLow{};
  Vector3 BoxHigh{};
  std::vector<std::array<double, 4>> ClippingPlanes;
  Vector3 CroppingLow{};
  Vector3 CroppingHigh{};
  int CroppingFlags = 0;
  double ShadowSampleDistance = 0.0;

  bool operator==(const ShadowingMatter& other) const;
  bool operator!=(const ShadowingMatter& other) const { return !(*this == other); }
};

ShadowingMatter DescribeShadowingMatter(
  const DrawnScene& scene, const VolumeTextures& textures, vtkVolumeProperty* property);

}

#endif
