#include "ShadowSettings.h"

#include "DrawnScene.h"
#include "PictureRequest.h"
#include "ShadowChoice.h"
#include "StepPreparation.h"
#include "VolumeTextures.h"

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace penumbra
{
namespace
{
double CountVisibleVoxels(const VolumePlacement& placement)
{
  double voxels = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    voxels *= 1.0 + (placement.BoxHigh[axis] - placement.BoxLow[axis]) * placement.Dimensions[axis];
  }
  return voxels;
}

ShadowChoiceTask DescribeChoice(const PictureRequest& request, const DrawnScene& scene,
  const VolumeTextures& textures, std::size_t largestBytes)
{
  const VolumePlacement& placement = scene.Placement;
  ShadowChoiceTask task;
  task.SoftLights = scene.Requirements.GetNumberOfLights(ShadowKind::Soft);
  task.HardLights = scene.Requirements.GetNumberOfLights(ShadowKind::Hard);
  task.Brightness = scene.Lights.GetShadowedBrightness(scene.Requirements);
  // Whether rays leap over it or not: that must not change the choice.
  const EmptySpaceReport& matter = textures.GetEmptySpaceReport();
  task.VoxelDepth = matter.MeanExtinction * placement.SmallestSpacing;
  task.Occupied = 1.0 * matter.OccupiedBricks / std::max(matter.Bricks, 1);
  const SampleDistances distances = ShortenSteepSteps(GetSampleDistances(request.Mapper), scene);
  task.ShadowStep = distances.Shadow / placement.SmallestSpacing;
  task.SpacingRatio = placement.LargestSpacing / placement.SmallestSpacing;
  task.SteepOpacity = scene.Requirements.PreIntegrated;
  const int* size = request.Renderer->GetSize();
  task.Pixels = 1.0 * size[0] * size[1];
  task.VoxelsAcross = placement.GetDiagonal() / placement.SmallestSpacing;
  task.Voxels = CountVisibleVoxels(placement);
  task.MatterAcross = matter.DrawIn(placement).GetDiagonal() / placement.SmallestSpacing;
  task.LargestBytes = largestBytes;
  task.Tolerance = request.Mapper->GetShadowTolerance();
  return task;
}
}

//------------------------------------------------------------------------------
ShadowSettings DecideShadows(
  const PictureRequest& request, const DrawnScene& scene, const VolumeTextures& textures)
{
  vtkIlluminatedVolumeMapper* mapper = request.Mapper;
  ShadowSettings settings;
  settings.Resolution = mapper->GetShadowResolution();
  settings.NearSteps = mapper->GetShadowNearSteps();
  settings.MemoryLimit = mapper->GetShadowMemoryLimit();
  if (!scene.AnythingVisible)
  {
    settings.Reason = "nothing is visible";
  }
  else if (mapper->GetShadowTechnique() == vtkIlluminatedVolumeMapper::Auto)
  {
    const ShadowChoice choice =
      ChooseShadowTechnique(DescribeChoice(request, scene, textures, settings.GetLargestBytes()));
    settings.Technique = choice.Technique;
    settings.Resolution *= choice.Resolution;
    settings.NearSteps = choice.NearSteps;
    settings.Chosen = true;
    settings.Reason = choice.Reason;
  }
  else
  {
    settings.Technique =
      static_cast<ShadowTechnique>(mapper->GetShadowTechnique() - vtkIlluminatedVolumeMapper::Rays);
    settings.Reason = "as asked";
  }
  return settings;
}

}
