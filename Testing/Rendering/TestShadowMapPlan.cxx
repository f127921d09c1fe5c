#include "Catch.h"
#include "MakeMapTask.h"
#include "ShadowMapPlan.h"

using namespace penumbra;

TEST_CASE("A shadow map has as many texels to a voxel as asked")
{
  ShadowMapTask task = MakeMapTask(300.0, 3);
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
  ShadowMapTask task = MakeMapTask(1000.0, 2);
  task.LargestBytes = 10000000;
  const ShadowMapPlan plan = PlanShadowMaps(task);
  CHECK(plan.Coarsened);
  CHECK(plan.GetBytes() <= task.LargestBytes);
  // A row and a column less is a hundredth of it.
  CHECK(plan.GetBytes() >= 9800000);
}

TEST_CASE("OpenGL's largest texture bounds the maps' size and their number")
{
  ShadowMapTask task = MakeMapTask(1000.0, 100);
  task.LargestSize = 256;
  const ShadowMapPlan plan = PlanShadowMaps(task);
  CHECK(plan.Coarsened);
  CHECK(plan.Texels == 256);
  CHECK(plan.Lights == 64);
}
