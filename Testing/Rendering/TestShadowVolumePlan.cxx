#include "Catch.h"
#include "ShadowVolumePlan.h"

using namespace penumbra;

namespace
{
constexpr std::size_t Plenty = std::size_t(1) << 40;

ShadowVolumeTask MakeTask(const Vector3& voxels, int lights)
{
  ShadowVolumeTask task;
  task.Voxels = voxels;
  task.Lights = lights;
  task.LargestSize = 2048;
  task.LargestBytes = Plenty;
  return task;
}
}

TEST_CASE("Texels of resolution 1 stand at the voxels, and as many to a voxel as asked")
{
  ShadowVolumeTask task = MakeTask({ 255.0, 127.0, 0.0 }, 1);
  // An axis of one voxel is one voxel thick, from face to face.
  task.Voxels[2] = 1.0;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 256, 128, 2 });
  task.Resolution = 0.5;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 129, 65, 2 });
  task.Resolution = 2.0;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 511, 255, 3 });
  CHECK_FALSE(PlanShadowVolume(task).Coarsened);
}

TEST_CASE("Texels are even, up to two to a voxel")
{
  ShadowVolumeTask task = MakeTask({ 512.0, 512.0, 133.0 }, 1);
  task.VoxelEdges = { 1.0, 1.0, 3.5 };
  task.Resolution = 0.5;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 257, 257, 234 });
  task.Resolution = 0.8;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 411, 411, 267 });
  task.Resolution = 1.0;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 513, 513, 267 });
  task.Resolution = 3.0;
  CHECK(PlanShadowVolume(task).Texels == std::array<int, 3>{ 1537, 1537, 400 });
}

TEST_CASE("Four lights share a texel, and further ones stand behind")
{
  const auto [lights, components, blocks] = GENERATE(table<int, int, int>(
    { { 1, 1, 1 }, { 2, 2, 1 }, { 3, 4, 1 }, { 4, 4, 1 }, { 5, 4, 2 }, { 9, 4, 3 } }));
  const ShadowVolumePlan plan = PlanShadowVolume(MakeTask({ 9.0, 19.0, 29.0 }, lights));
  CHECK(plan.Lights == lights);
  CHECK(plan.Components == components);
  CHECK(plan.Blocks == blocks);
  CHECK(plan.GetNumberOfSlices() == 30 * blocks);
  CHECK(plan.GetBytes() == static_cast<std::size_t>(10 * 20 * 30 * components * blocks));
}

TEST_CASE("A shadow volume takes no more memory than it may, and little less")
{
  const int lights = GENERATE(1, 2, 4, 7);
  const std::size_t limit = GENERATE(10000, 1000000, 50000000);
  ShadowVolumeTask task = MakeTask({ 511.0, 511.0, 300.0 }, lights);
  task.LargestBytes = limit;
  const ShadowVolumePlan plan = PlanShadowVolume(task);
  CHECK(plan.Coarsened);
  CHECK(plan.Lights == lights);
  CHECK(plan.GetBytes() <= limit);
  // A step of the search leaves a tenth, rounding of small axes somewhat more.
  CHECK(static_cast<double>(plan.GetBytes()) >= 0.75 * static_cast<double>(limit));
}

TEST_CASE("The largest texture bounds the resolution of one axis and the number of lights")
{
  ShadowVolumeTask task = MakeTask({ 399.0, 99.0, 99.0 }, 12);
  task.LargestSize = 256;
  const ShadowVolumePlan plan = PlanShadowVolume(task);
  CHECK(plan.Coarsened);
  // Texels stay as long along all axes.
  CHECK(plan.Texels == std::array<int, 3>{ 256, 64, 64 });
  CHECK(plan.Lights == 12);
  task.Lights = 17;
  CHECK(PlanShadowVolume(task).Lights == 16);
  CHECK(PlanShadowVolume(task).GetNumberOfSlices() == 256);
}

TEST_CASE("However little memory there is, a plan is found")
{
  ShadowVolumeTask task = MakeTask({ 1e5, 1e5, 1e5 }, 100);
  task.LargestBytes = 0;
  const ShadowVolumePlan plan = PlanShadowVolume(task);
  CHECK(plan.Texels == std::array<int, 3>{ 2, 2, 2 });
  CHECK(plan.Lights == 4);
}
