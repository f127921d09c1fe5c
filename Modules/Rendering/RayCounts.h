/**
 * @file    RayCounts.h
 * @brief   what the rays of a picture do, over all its pixels
 */

#ifndef RayCounts_h
#define RayCounts_h

namespace penumbra
{

struct RayCounts
{
  double Samples = 0.0;       ///< of view rays, with matter or without
  double ShadedSamples = 0.0; ///< those of them whose light was computed
  double ShadowSteps = 0.0;   ///< of the rays from samples towards lights
};

}

#endif
