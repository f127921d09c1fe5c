#include "Catch.h"
#include "MakeMapTask.h"
#include "OpacityMapPlan.h"

using namespace penumbra;

TEST_CASE("An opacity map has as many texels and layers to a voxel as asked, and a border")
{
  ShadowMapTask task = MakeMapTask(300.0, 3);
  const OpacityMapPlan plan = PlanOpacityMaps(task);
  CHECK(plan.Texels == 302);
  // 300 cells have 301 ends, and that is a whole number of draws already.
  CHECK(plan.Layers == 301);
  CHECK(plan.GetNumberOfSlices() == 903);
  CHECK(plan.GetBytes() == std::size_t(302) * 302 * 903 * 2);
  CHECK_FALSE(plan.Coarsened);
  task.Resolution = 0.5;
  CHECK(PlanOpacityMaps(task).Texels == 152);
  CHECK(PlanOpacityMaps(task).Layers == 154);
  CHECK(PlanOpacityMaps(task).Resolution == Approx(0.5));
}

TEST_CASE("The layers reach from the box's near end to its far end")
{
  LightSpace space;
  space.Nearest = 20.0;
  space.Farthest = 80.0;
  OpacityMapPlan plan;
  plan.Layers = 7;
  CHECK(plan.GetSpacing(space) == Approx(10.0));
}

TEST_CASE("Opacity maps take no more memory than they may, and hardly less")
{
  ShadowMapTask task = MakeMapTask(500.0, 2);
  task.LargestBytes = 100000000;
  const OpacityMapPlan plan = PlanOpacityMaps(task);
  CHECK(plan.Coarsened);
  CHECK(plan.Lights == 2);
  CHECK(plan.GetBytes() <= task.LargestBytes);
  // A step of the search, and layers that fill the last draw.
  CHECK(plan.GetBytes() >= 88000000);
  task.Span = 510.0;
  CHECK(PlanOpacityMaps(task).Texels == plan.Texels);
}

TEST_CASE("OpenGL's largest texture makes opacity maps coarser first, and then fewer")
{
  ShadowMapTask task = MakeMapTask(400.0, 4);
  task.LargestSize = 512;
  CHECK(PlanOpacityMaps(task).Lights == 4);
  CHECK(PlanOpacityMaps(task).Resolution < 0.32);
  task.Lights = 9;
  const OpacityMapPlan plan = PlanOpacityMaps(task);
  CHECK(plan.Lights == 4);
  CHECK(plan.Resolution >= 0.25);
  task.LargestBytes = 1000;
  CHECK(PlanOpacityMaps(task).Lights == 0);
}
