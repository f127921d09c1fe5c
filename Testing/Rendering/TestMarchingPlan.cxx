#include "Catch.h"
#include "MarchingPlan.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace penumbra;

namespace
{
constexpr double LargestNumberOfIterations = 60000.0;
constexpr double LargestNumberOfSteps = 65536.0;

// Loop iterations of one view step, counted in the shaders: ViewRay.glsl's two loops, a search for
// opacity and one for colour, a loop over the lights; ShadowRay.glsl's loop of four steps with a
// search each, and the loop over the clipping planes that bound it.
double CountIterationsPerStep(const MarchingTask& task, double shadowSampleDistance)
{
  const double shadowSteps = std::ceil(task.Diagonal / shadowSampleDistance) + 1.0;
  const double shadowRay =
    task.ClippingPlanes + std::ceil(shadowSteps / 4.0) * (1.0 + 4.0 * task.LookupIterations);
  const double lit = 1.0 + task.LookupIterations + task.Lights + task.ShadowedLights * shadowRay;
  return 2.0 + task.LookupIterations + (task.HalvedSteps ? 2.0 : 1.0) * lit;
}

MarchingTask MakeTask(double diagonal, double sampleDistance, double shadowSampleDistance)
{
  MarchingTask task;
  task.Diagonal = diagonal;
  task.SampleDistance = sampleDistance;
  task.ShadowSampleDistance = shadowSampleDistance;
  return task;
}

// Diagonals and steps from tiny to huge, no light to 32 shadowed ones, tables and searches.
void ForEachTask(const std::function<void(const MarchingTask&)>& check)
{
  for (const double diagonal : { 1e-6, 1.0, 222.0, 1e9 })
  {
    for (const double steps : { 1e-3, 1.0, 100.0, 1e4, 1e6, 1e12 })
    {
      for (const double shadowSteps : { 1e-3, 10.0, 1e3, 2e5, 1e12 })
      {
        for (const int shadowedLights : { 0, 1, 32 })
        {
          for (const int lookupIterations : { 0, 14 })
          {
            MarchingTask task = MakeTask(diagonal, diagonal / steps, diagonal / shadowSteps);
            task.ShadowedLights = shadowedLights;
            task.Lights = shadowedLights + 1;
            task.LookupIterations = lookupIterations;
            task.ClippingPlanes = 6;
            task.HalvedSteps = lookupIterations > 0;
            INFO("diagonal " << diagonal << ", " << steps << " steps, " << shadowSteps
                             << " shadow steps, " << shadowedLights << " shadowed lights, search "
                             << lookupIterations);
            check(task);
          }
        }
      }
    }
  }
}
}

TEST_CASE("No draw exceeds the bound, and all draws together take every step")
{
  ForEachTask(
    [](const MarchingTask& task)
    {
      const MarchingPlan plan = PlanMarching(task);
      const double perStep = CountIterationsPerStep(task, plan.ShadowSampleDistance);
      CHECK(plan.StepsPerDraw >= 1);
      CHECK(plan.StepsPerDraw * perStep <= LargestNumberOfIterations);
      CHECK(plan.Steps >= task.Diagonal / plan.SampleDistance);
      CHECK(static_cast<double>(plan.Draws) * plan.StepsPerDraw >= plan.Steps);
    });
}

TEST_CASE("No draw is more than needed")
{
  ForEachTask(
    [](const MarchingTask& task)
    {
      const MarchingPlan plan = PlanMarching(task);
      const double perStep = CountIterationsPerStep(task, plan.ShadowSampleDistance);
      CHECK(static_cast<double>(plan.Draws - 1) * plan.StepsPerDraw < plan.Steps);
      CHECK((plan.Draws == 1 || (plan.StepsPerDraw + 1) * perStep > LargestNumberOfIterations));
      CHECK(plan.StepsPerDraw <= plan.Steps);
    });
}

TEST_CASE("Steps are as asked unless that cannot be drawn, and then no longer than needed")
{
  ForEachTask(
    [](const MarchingTask& task)
    {
      const MarchingPlan plan = PlanMarching(task);
      const double shortest = task.Diagonal / LargestNumberOfSteps;
      CHECK(plan.SampleDistance == std::max(task.SampleDistance, shortest));
      const double shadow = std::max(task.ShadowSampleDistance, shortest);
      if (CountIterationsPerStep(task, shadow) <= LargestNumberOfIterations)
      {
        CHECK(plan.ShadowSampleDistance == shadow);
      }
      else
      {
        CHECK(plan.ShadowSampleDistance > shadow);
        CHECK(CountIterationsPerStep(task, 0.5 * plan.ShadowSampleDistance) >
          LargestNumberOfIterations);
      }
      CHECK(plan.Coarsened ==
        (plan.SampleDistance != task.SampleDistance ||
          plan.ShadowSampleDistance != task.ShadowSampleDistance));
    });
}

TEST_CASE("A picture of usual size is one draw as asked")
{
  MarchingTask task = MakeTask(222.0, 0.5, 1.0);
  task.Lights = 3;
  task.ShadowedLights = 1;
  const MarchingPlan plan = PlanMarching(task);
  CHECK(plan.Draws == 1);
  CHECK(plan.Steps == 445);
  CHECK_FALSE(plan.Coarsened);
}

TEST_CASE("Steps of a billionth and 32 shadowed lights can be drawn, coarser")
{
  MarchingTask task = MakeTask(1000.0, 1e-9, 1e-9);
  task.Lights = 32;
  task.ShadowedLights = 32;
  const MarchingPlan plan = PlanMarching(task);
  CHECK(plan.Coarsened);
  CHECK(plan.SampleDistance == Approx(1000.0 / LargestNumberOfSteps));
  CHECK(CountIterationsPerStep(task, plan.ShadowSampleDistance) <= LargestNumberOfIterations);
}

TEST_CASE("A box without extent takes one draw of at least one step")
{
  const MarchingPlan plan = PlanMarching(MakeTask(0.0, 0.5, 1.0));
  CHECK(plan.Draws == 1);
  CHECK(plan.Steps >= 1);
  CHECK_FALSE(plan.Coarsened);
}

// Nothing can be done about planes: the plan still ends.
TEST_CASE("A plan ends even where one step alone exceeds the bound")
{
  MarchingTask task = MakeTask(100.0, 0.5, 1.0);
  task.Lights = task.ShadowedLights = 32;
  task.ClippingPlanes = 3000;
  const MarchingPlan plan = PlanMarching(task);
  CHECK(plan.StepsPerDraw == 1);
  CHECK(plan.Draws == plan.Steps);
}
