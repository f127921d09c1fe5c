/**
 * @file    KeptShadowDifference.h
 * @brief   how far shadows that are kept are from the rays' that define them
 */

#ifndef KeptShadowDifference_h
#define KeptShadowDifference_h

#include "IlluminatedScene.h"
#include "ImageComparison.h"

namespace penumbra
{

/// From rays of half the step that the technique is given.
ImageDifference DifferenceFromRays(IlluminatedScene& scene, int technique);

}

#endif
