/**
 * @file PartlyHidden.h
 * @brief Even matter from z = 3 to z = 11, of which parts are hidden, and how it dims light.
 */
#ifndef PartlyHidden_h
#define PartlyHidden_h

#include "ShadowedVolume.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
constexpr double Extinction = 0.1;
/// Of visibilities in single precision.
constexpr double Rounding = 2e-6;

inline VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 9, 8, 17 };
  grid.spacing = { 1.0, 1.2, 0.5 };
  grid.origin = { 2.0, -1.0, 3.0 };
  return grid;
}

/// What passes through this length of the matter.
inline double Dim(double length)
{
  return std::exp(-Extinction * std::max(length, 0.0));
}
}

#endif
