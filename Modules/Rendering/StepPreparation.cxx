#include "StepPreparation.h"

#include "DrawnScene.h"
#include "VolumeTextures.h"

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
bool IsStepLength(double length)
{
  constexpr double longest = 1e30;
  return length > 0.0 && length < longest;
}

double GetDefaultViewStep(vtkImageData* image)
{
  if (!image)
  {
    return 1.0;
  }
  const double* spacing = image->GetSpacing();
  return 0.5 * std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}
}

//------------------------------------------------------------------------------
SampleDistances GetSampleDistances(vtkIlluminatedVolumeMapper* mapper)
{
  SampleDistances distances;
  const double view = mapper->GetSampleDistance();
  const double shadow = mapper->GetShadowSampleDistance();
  distances.View = IsStepLength(view)
    ? view
    : GetDefaultViewStep(vtkImageData::SafeDownCast(mapper->GetDataSetInput()));
  distances.Shadow = IsStepLength(shadow) ? shadow : 2.0 * distances.View;
  return distances;
}

//------------------------------------------------------------------------------
void PrepareSteps(const SampleDistances& distances, int nearSteps, DrawnScene& scene,
  const VolumeTextures& textures, std::vector<std::string>& messages)
{
  const LightingRequirements& needs = scene.Requirements;
  MarchingTask task;
  task.Diagonal = scene.Placement.GetDiagonal();
  task.SampleDistance = distances.View;
  task.ShadowSampleDistance = distances.Shadow;
  if (!scene.ShadowCasters.empty())
  {
    // What is kept is marched once: with half the step, interpolation is all the error there is.
    task.ShadowSampleDistance *= 0.5;
  }
  task.Lights = needs.GetNumberOfLights();
  task.LookedUpShadows = static_cast<int>(scene.ShadowCasters.size());
  task.ShadowMaps = scene.MapsOfShadows.Lights > 0;
  task.ShadowNearSteps = nearSteps;
  task.ShadowedLights = needs.GetNumberOfShadowedLights() - task.LookedUpShadows;
  task.LookupIterations = needs.Opacity == TransferFunctionLookup::Points
    ? textures.GetTransferFunctions().GetLookupIterations()
    : 0;
  task.ClippingPlanes = needs.ClippingPlanes;
  scene.Plan = PlanMarching(task);
  if (scene.Plan.Coarsened)
  {
    messages.emplace_back(
      "Steps are longer than asked: rays would have more of them than can be drawn.");
  }
}

}
