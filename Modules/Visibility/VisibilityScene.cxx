#include "VisibilityScene.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkVolumeLight.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <utility>

namespace penumbra
{
namespace
{
// Long before rounding joins neighbouring steps, a ray would take too long to be of use.
constexpr double MostSteps = 16777216.0;

//------------------------------------------------------------------------------
double GetSampleDistance(const VisibilityScene& scene, const VolumeFrames& frames)
{
  return scene.SampleDistance > 0.0 ? scene.SampleDistance : 0.5 * frames.SmallestSpacing;
}

//------------------------------------------------------------------------------
std::string FindObstacleInProperty(vtkVolumeProperty* property)
{
  if (!property || property->GetScalarOpacity(0)->GetSize() == 0)
  {
    return "An opacity function is needed: a volume property whose scalar opacity has points.";
  }
  if (property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    return "Two-dimensional transfer functions are not supported.";
  }
  return property->GetScalarOpacityUnitDistance(0) > 0.0
    ? ""
    : "The scalar opacity's unit distance must be above 0.";
}

//------------------------------------------------------------------------------
std::string FindObstacleInScalars(vtkImageData* volume, vtkDataArray* scalars)
{
  if (volume->GetNumberOfPoints() == 0)
  {
    return "The volume has no voxels.";
  }
  if (!scalars)
  {
    return volume->GetCellData()->GetScalars()
      ? "The volume has cell data; scalars at the points are needed."
      : "The volume has no scalars at its points.";
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    return "The volume has " + std::to_string(scalars->GetNumberOfComponents()) +
      " components; one is needed.";
  }
  return scalars->GetNumberOfTuples() == volume->GetNumberOfPoints()
    ? ""
    : "The volume has another number of scalars than of points.";
}

//------------------------------------------------------------------------------
std::string FindObstacleInMask(vtkImageData* mask, vtkImageData* volume)
{
  const bool usable = !mask ||
    (mask->GetPointData()->GetScalars() &&
      std::equal(mask->GetDimensions(), mask->GetDimensions() + 3, volume->GetDimensions()));
  return usable ? "" : "The mask needs scalars at its points and the volume's dimensions.";
}

//------------------------------------------------------------------------------
std::string FindObstacleInLights(vtkLightCollection* lights)
{
  const bool any = lights && !FindShadowedLights(lights).empty();
  return any ? "" : "A vtkVolumeLight is needed that is on and casts a shadow.";
}

//------------------------------------------------------------------------------
std::string FindObstacleInGeometry(const VisibilityScene& scene)
{
  VolumeFrames frames;
  if (!ComputeVolumeFrames(scene.Volume, scene.Matrix, frames))
  {
    return "The volume's spacing, direction or matrix has no inverse.";
  }
  return frames.GetDiagonal() / GetSampleDistance(scene, frames) <= MostSteps
    ? ""
    : "The sample distance is too small: rays would have more than 2^24 steps.";
}

//------------------------------------------------------------------------------
VisibleRegion MakeRegion(const VisibilityScene& scene, const VolumeFrames& frames)
{
  VisibleRegion region(frames);
  if (scene.CroppingPlanes)
  {
    Vector3 low;
    Vector3 high;
    ComputeCroppingInterval(scene.Volume, scene.CroppingPlanes, low, high);
    region.Crop(low, high);
  }
  const int planes = scene.ClippingPlanes ? scene.ClippingPlanes->GetNumberOfItems() : 0;
  for (int plane = 0; plane < planes; ++plane)
  {
    region.Clip(scene.ClippingPlanes->GetItem(plane));
  }
  return region;
}
}

//------------------------------------------------------------------------------
std::string FindObstacle(const VisibilityScene& scene)
{
  const std::function<std::string()> searches[] = {
    [&]() { return FindObstacleInProperty(scene.Property); },
    [&]() { return FindObstacleInLights(scene.Lights); },
    [&]() { return FindObstacleInScalars(scene.Volume, scene.Scalars); },
    [&]() { return FindObstacleInMask(scene.Mask, scene.Volume); },
    [&]() { return FindObstacleInGeometry(scene); },
  };
  for (const auto& find : searches)
  {
    const std::string obstacle = find();
    if (!obstacle.empty())
    {
      return obstacle;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
VisibilityTask MakeVisibilityTask(const VisibilityScene& scene, const UsableScalars& scalars)
{
  VisibilityTask task;
  ComputeVolumeFrames(scene.Volume, scene.Matrix, task.Frames);
  task.Region = MakeRegion(scene, task.Frames);
  MediumDescription description;
  description.Frames = task.Frames;
  description.Property = scene.Property;
  description.Estimator = scene.Estimator;
  description.Mask = scene.Mask ? scene.Mask->GetPointData()->GetScalars() : nullptr;
  description.SampleDistance = GetSampleDistance(scene, task.Frames);
  task.Matter = MakeMedium(scalars, description);
  task.Lights = MakeShadowedLights(
    scene.Lights, task.Frames, scene.CameraDirection, scene.NegligibleVisibility);
  return task;
}

}
