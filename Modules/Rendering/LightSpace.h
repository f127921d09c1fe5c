/**
 * @file    LightSpace.h
 * @brief   a map of the rays of one light through a volume's box
 *
 * A point of the volume has a place (u, v) on the light's map, in [0, 1], which is that of its ray,
 * and a distance along the ray in own lengths, which grows away from the light. Rays of a
 * directional light are mapped by their parallel projection; those of a point light by perspective
 * where the box lies within a cone before it, else, the light inside or close by, all around it by
 * octahedral coordinates (Meyer et al. 2010, "On floating-point normal vectors"). A light very far
 * away has parallel rays.
 */

#ifndef LightSpace_h
#define LightSpace_h

#include "PenumbraRenderingModule.h" // For export macro
#include "VolumePlacement.h"

#include <array>

namespace penumbra
{

enum class LightProjection
{
  Parallel,
  Perspective,
  Octahedral
};

struct PENUMBRARENDERING_EXPORT LightSpace
{
  LightProjection Projection = LightProjection::Parallel;
  /// Affine maps between texture coordinates of the volume and the light's frame. Parallel: u, v
  /// and the distance; else own lengths from the light, the third axis towards the box.
  Matrix4 TextureToLight{};
  Matrix4 LightToTexture{};
  /// Perspective: largest ratio of the first two coordinates to the third.
  double Extent = 1.0;
  /// The box lies between these distances.
  double Nearest = 0.0;
  double Farthest = 0.0;
};

/// place: position and 1 of a point light, or direction of the shadow rays and 0, in texture
/// coordinates.
PENUMBRARENDERING_EXPORT LightSpace ComputeLightSpace(
  const VolumePlacement& placement, const std::array<float, 4>& place);

}

#endif
