#include "ShadowVolumePlan.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr int LightsPerBlock = 4;

int CountBlocks(int lights)
{
  return (lights + LightsPerBlock - 1) / LightsPerBlock;
}

double GetTexelsPerVoxel(const ShadowVolumeTask& task, double resolution, int axis)
{
  constexpr double mostOfLongVoxels = 2.0;
  return std::min(resolution * task.VoxelEdges[axis], std::max(resolution, mostOfLongVoxels));
}

void SetResolution(const ShadowVolumeTask& task, double resolution, ShadowVolumePlan& plan)
{
  plan.Resolution = resolution;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double texels =
      std::round(GetTexelsPerVoxel(task, resolution, axis) * task.Voxels[axis]) + 1.0;
    plan.Texels[axis] = static_cast<int>(std::clamp(texels, 2.0, 1.0 * task.LargestSize));
  }
}

// Of the largest axis, which the largest texture bounds.
double GetLargestResolution(const ShadowVolumeTask& task)
{
  const double longest = *std::max_element(task.Voxels.begin(), task.Voxels.end());
  return longest > 0.0 ? (task.LargestSize - 1.0) / longest : task.Resolution;
}
}

//------------------------------------------------------------------------------
std::size_t ShadowVolumePlan::GetBytes() const
{
  return static_cast<std::size_t>(this->Texels[0]) * static_cast<std::size_t>(this->Texels[1]) *
    static_cast<std::size_t>(this->GetNumberOfSlices()) *
    static_cast<std::size_t>(this->Components);
}

//------------------------------------------------------------------------------
ShadowVolumePlan PlanShadowVolume(const ShadowVolumeTask& task)
{
  constexpr double step = 0.97; // small, so that little of the memory is left unused
  constexpr std::size_t fewest = 2 * 2 * 2 * LightsPerBlock;
  const std::size_t largestBytes = std::max(task.LargestBytes, fewest);
  ShadowVolumePlan plan;
  double resolution = std::min(task.Resolution, GetLargestResolution(task));
  for (bool fits = false; !fits; resolution *= step)
  {
    SetResolution(task, resolution, plan);
    const int mostBlocks = std::max(task.LargestSize / plan.Texels[2], 1);
    plan.Lights = std::min(task.Lights, LightsPerBlock * mostBlocks);
    plan.Blocks = CountBlocks(plan.Lights);
    plan.Components = plan.Lights <= 2 ? plan.Lights : LightsPerBlock;
    const bool smallest = plan.Texels == std::array<int, 3>{ 2, 2, 2 };
    while (smallest && plan.GetBytes() > largestBytes && plan.Blocks > 1)
    {
      plan.Lights = LightsPerBlock * --plan.Blocks;
    }
    fits = smallest || plan.GetBytes() <= largestBytes;
  }
  plan.Coarsened = plan.Resolution < task.Resolution;
  return plan;
}

}
