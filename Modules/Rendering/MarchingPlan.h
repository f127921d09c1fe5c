/**
 * @file    MarchingPlan.h
 * @brief   how a picture is cut into draws so that no fragment is cut off
 *
 * Software rasterizers end a fragment after a number of loop iterations, all its loops together,
 * and graphics cards reset when a draw takes long. A picture that could exceed the bound is drawn
 * as several parts of its view rays, front to back, each going on with what the ones before it
 * gathered: the same samples, the same sums.
 */

#ifndef MarchingPlan_h
#define MarchingPlan_h

#include "PenumbraRenderingModule.h" // For export macro

namespace penumbra
{

struct MarchingTask
{
  double Diagonal = 0.0;             ///< longest way through the visible box, own lengths
  double SampleDistance = 0.0;       ///< as asked, more than 0
  double ShadowSampleDistance = 0.0; ///< as asked, more than 0
  bool HalvedSteps = false;          ///< a view step may be lit twice
  int Lights = 0;
  int ShadowedLights = 0;   ///< whose rays are marched whole
  int LookedUpShadows = 0;  ///< lights whose rays are marched for some steps only
  int ShadowNearSteps = 0;  ///< how many those are
  bool ShadowMaps = false;  ///< looked up in maps, else in a volume
  int LookupIterations = 0; ///< loop iterations of one transfer function look-up
  int ClippingPlanes = 0;
};

struct MarchingPlan
{
  double SampleDistance = 0.0;
  double ShadowSampleDistance = 0.0;
  int Steps = 0; ///< steps of the longest view ray
  int StepsPerDraw = 0;
  int Draws = 1;
  bool Coarsened = false; ///< a step is longer than asked
};

/// The least number of draws of which none can exceed the bound. Steps are made longer than asked
/// only where a ray would have more of them than single precision can place well, or where one view
/// step alone would exceed the bound; where longer shadow steps do not help, such a step is a draw
/// of its own.
PENUMBRARENDERING_EXPORT MarchingPlan PlanMarching(const MarchingTask& task);

}

#endif
