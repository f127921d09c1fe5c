#include "Catch.h"
#include "ShadowMapPlan.h"

using namespace penumbra;

namespace
{
ShadowMapTask MakeTask(double span, int lights)
{
  ShadowMapTask task;
  task.Span = span;
  task.Lights = lights;
  task.LargestSize = 2048;
  task.LargestBytes = std::size_t(1) << 40;
  return task;
}
}

TEST_CASE("A shadow map has as many texels to a voxel as asked")
{
  ShadowMapTask task = MakeTask(300.0, 3);
  CHECK(PlanShadowMaps(task).Texels == 300);
  CHECK(PlanShadowMaps(task).GetNumberOfSlices() == 12);
  CHECK(PlanShadowMaps(task).GetBytes() == 300 * 300 * 12 * 16);
  task.Resolution = 1.5;
  CHECK(PlanShadowMaps(task).Texels == 450);
  CHECK(PlanShadowMaps(task).Resolution == Approx(1.5));
  CHECK_FALSE(PlanShadowMaps(task).Coarsened);
}

TEST_CASE("Shadow maps take no more memory than they may, and hardly less")
{
  ShadowMapTask task = MakeTask(1000.0, 2);
  task.LargestBytes = 10000000;
  const ShadowMapPlan plan = PlanShadowMaps(task);
  CHECK(plan.Coarsened);
  CHECK(plan.GetBytes() <= task.LargestBytes);
  // A row and a column less is a hundredth of it.
  CHECK(plan.GetBytes() >= 9800000);
}

TEST_CASE("OpenGL's largest texture bounds the maps' size and their number")
{
  ShadowMapTask task = MakeTask(1000.0, 100);
  task.LargestSize = 256;
  const ShadowMapPlan plan = PlanShadowMaps(task);
  CHECK(plan.Coarsened);
  CHECK(plan.Texels == 256);
  CHECK(plan.Lights == 64);
}
