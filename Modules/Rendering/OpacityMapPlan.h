/**
 * @file    OpacityMapPlan.h
 * @brief   how many texels, layers and lights opacity shadow maps hold
 */

#ifndef OpacityMapPlan_h
#define OpacityMapPlan_h

#include "LightSpace.h"
#include "PenumbraRenderingModule.h" // For export macro
#include "ShadowMapPlan.h"

#include <cstddef>

namespace penumbra
{

/// The maps are blocks of layers, one behind another. Texels of a map have a border of one around
/// them. What exceeds the memory allowed, or the largest texture, is made coarser; lights whose
/// maps would be coarser than a quarter of what is asked are not held.
struct PENUMBRARENDERING_EXPORT OpacityMapPlan
{
  static constexpr int LayersPerDraw = 7;
  static constexpr int BytesPerTexel = 2;

  int Texels = 0;          ///< along both axes, the border included
  int Layers = 0;          ///< of a map
  int Lights = 0;          ///< that it holds, the first ones
  double Resolution = 0.0; ///< texels and layers a voxel, the fewer
  bool Coarsened = false;  ///< the resolution is less than asked
  int TextureTexels = 0;   ///< along both axes of the texture that holds the maps, not less
  int TextureSlices = 0;   ///< of it

  std::size_t GetBytes() const;
  int GetNumberOfSlices() const { return this->Layers * this->Lights; }
  /// Distance from layer to layer of a light's map.
  double GetSpacing(const LightSpace& space) const
  {
    return (space.Farthest - space.Nearest) / (this->Layers - 1);
  }
};

/// Maps in a texture of their own size.
PENUMBRARENDERING_EXPORT OpacityMapPlan PlanOpacityMaps(const ShadowMapTask& task);

}

#endif
