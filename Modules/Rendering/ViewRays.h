/**
 * @file    ViewRays.h
 * @brief   the rays of a camera in a volume's texture coordinates
 */

#ifndef ViewRays_h
#define ViewRays_h

#include "PenumbraRenderingModule.h" // For export macro
#include "VolumePlacement.h"

#include <array>

namespace penumbra
{

/// View rays in texture coordinates as linear functions of the position (x, y) on the image plane
/// in normalized device coordinates: base + t * direction, the eye at t = EyeParameter.
struct PENUMBRARENDERING_EXPORT ViewRays
{
  Matrix3 Base{}; ///< columns: x, y, 1
  Matrix3 Direction{};
  double EyeParameter = 0.0;
  std::array<double, 4> ClipDepth{}; ///< rows z and w of the map from texture to clip coordinates
  std::array<double, 4> ClipW{};
  Matrix4 TextureToClip{};
};

/// Rays of a camera. worldToClip is the whole projection, z of the near plane -1. False where its
/// product with the placement has no inverse.
PENUMBRARENDERING_EXPORT bool ComputeViewRays(
  const VolumePlacement& placement, const Matrix4& worldToClip, const Vector3& eye, ViewRays& rays);

}

#endif
