#include "MarchingPlan.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// llvmpipe ends a fragment after 65,535 iterations.
constexpr double LargestNumberOfIterations = 60000.0;
// Positions along a ray are floats: with 2^16 steps each still has a precision of a hundredth of a
// step.
constexpr double LargestNumberOfSteps = 65536.0;
// ShadowRay.glsl takes this many steps an iteration.
constexpr double ShadowStepsPerIteration = 4.0;
// ShadowDepthMap.glsl looks four functions of four texels up.
constexpr double IterationsPerMapLookUp = 20.0;
// ShadowMapFill.glsl marches a ray anew for each tolerance from a two-hundredth to 1, and for two
// between the last ones.
constexpr double MapMarches = 8.0;

double CountSteps(double length, double stepLength)
{
  return std::ceil(length / stepLength) + 1.0;
}

double CountIterationsPerRay(const MarchingTask& task, double shadowSteps)
{
  const double shadowIterations = std::ceil(shadowSteps / ShadowStepsPerIteration);
  return task.ClippingPlanes +
    shadowIterations * (1.0 + ShadowStepsPerIteration * task.LookupIterations);
}

// The loops of one view step: a leap before it, the step itself, its look-ups, the loop over the
// lights and their rays.
double CountIterationsPerStep(const MarchingTask& task, double shadowSteps)
{
  const double perRay = CountIterationsPerRay(task, shadowSteps);
  const double near =
    CountIterationsPerRay(task, std::min(1.0 * task.ShadowNearSteps, shadowSteps));
  const double lookUp = task.ShadowMaps ? IterationsPerMapLookUp : 0.0;
  const double marched = 2.0 + task.LookupIterations;
  const double lit = 1.0 + task.LookupIterations + task.Lights + task.ShadowedLights * perRay +
    task.LookedUpShadows * (near + lookUp);
  return marched + (task.HalvedSteps ? 2.0 : 1.0) * lit;
}

// Of a fragment of what is looked up.
double CountIterationsPerTexel(const MarchingTask& task, double shadowSteps)
{
  if (task.LookedUpShadows == 0)
  {
    return 0.0;
  }
  return task.ShadowMaps
    ? task.ClippingPlanes + MapMarches * shadowSteps * (1.0 + task.LookupIterations)
    : CountIterationsPerRay(task, shadowSteps);
}
}

//------------------------------------------------------------------------------
MarchingPlan PlanMarching(const MarchingTask& task)
{
  MarchingPlan plan;
  const double shortest = task.Diagonal / LargestNumberOfSteps;
  plan.SampleDistance = std::max(task.SampleDistance, shortest);
  plan.ShadowSampleDistance = std::max(task.ShadowSampleDistance, shortest);

  const double steps = CountSteps(task.Diagonal, plan.SampleDistance);
  double shadowSteps = CountSteps(task.Diagonal, plan.ShadowSampleDistance);
  while (std::max(CountIterationsPerStep(task, shadowSteps),
           CountIterationsPerTexel(task, shadowSteps)) > LargestNumberOfIterations &&
    plan.ShadowSampleDistance < task.Diagonal)
  {
    plan.ShadowSampleDistance *= 2.0;
    shadowSteps = CountSteps(task.Diagonal, plan.ShadowSampleDistance);
  }
  const double perStep = CountIterationsPerStep(task, shadowSteps);
  plan.Steps = static_cast<int>(steps);
  plan.StepsPerDraw =
    static_cast<int>(std::clamp(std::floor(LargestNumberOfIterations / perStep), 1.0, steps));
  plan.Draws = (plan.Steps + plan.StepsPerDraw - 1) / plan.StepsPerDraw;
  plan.Coarsened = plan.SampleDistance > task.SampleDistance ||
    plan.ShadowSampleDistance > task.ShadowSampleDistance;
  return plan;
}

}
