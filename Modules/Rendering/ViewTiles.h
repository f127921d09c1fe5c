/**
 * @file    ViewTiles.h
 * @brief   the parts of a picture that visible matter is seen in
 */

#ifndef ViewTiles_h
#define ViewTiles_h

#include "PenumbraRenderingModule.h" // For export macro
#include "ScalarBricks.h"
#include "VolumePlacement.h"

#include <array>
#include <cstddef>
#include <vector>

namespace penumbra
{

/// Rectangles of whole pixels that do not overlap, in normalized device coordinates.
struct ViewTiles
{
  /// Uniforms hold no more: 16 each of the twelve triangles of a box (ViewTiles.glsl).
  static constexpr std::size_t Most = 192;

  bool Everywhere = false;                      ///< matter surrounds the eye; no rectangles then
  std::vector<std::array<float, 4>> Rectangles; ///< low x and y, high x and y
};

/// Of pictures of width x height pixels. Every pixel with a ray through one of the bricks is in a
/// rectangle.
PENUMBRARENDERING_EXPORT ViewTiles FindViewTiles(const std::vector<int>& bricks,
  const BrickGrid& grid, const Matrix4& textureToClip, int width, int height);

}

#endif
