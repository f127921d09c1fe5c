/**
 * @file    ShadowMapPlan.h
 * @brief   how many texels and lights shadow maps hold
 */

#ifndef ShadowMapPlan_h
#define ShadowMapPlan_h

#include "PenumbraRenderingModule.h" // For export macro

#include <cstddef>

namespace penumbra
{

struct ShadowMapTask
{
  double Span = 0.0;       ///< length that a map spans, in voxels
  double Resolution = 1.0; ///< texels a voxel, more than 0
  int Lights = 0;          ///< with a shadow
  int LargestSize = 0;     ///< of a 3D texture along one axis
  std::size_t LargestBytes = 0;
};

/// A map is a stack of square slices, one behind another, each texel with two nodes of a function.
struct PENUMBRARENDERING_EXPORT ShadowMapPlan
{
  static constexpr int SlicesPerLight = 4;

  int Texels = 0; ///< along both axes
  int Lights = 0; ///< that it holds, the first ones
  double Resolution = 0.0;
  bool Coarsened = false; ///< the resolution is less than asked

  std::size_t GetBytes() const;
  int GetNumberOfSlices() const { return SlicesPerLight * this->Lights; }
};

PENUMBRARENDERING_EXPORT ShadowMapPlan PlanShadowMaps(const ShadowMapTask& task);

}

#endif
