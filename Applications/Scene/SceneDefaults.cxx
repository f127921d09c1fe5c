#include "SceneDefaults.h"

#include "Preset.h"
#include "SceneCamera.h"
#include "VolumeBox.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkStringArray.h>

namespace penumbra
{
namespace
{
// Which series a DICOM reader has taken.
void ResolveSeries(std::optional<std::string>& series, vtkImageData* image)
{
  auto* const taken =
    vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray("SeriesInstanceUID"));
  if (taken && taken->GetNumberOfValues() > 0 && !taken->GetValue(0).empty())
  {
    series = taken->GetValue(0);
  }
}

void ResolveTransferFunction(TransferFunctionDescription& function, vtkImageData* image)
{
  if (!function.Opacity || !function.Color)
  {
    const VolumeStatistics statistics(image);
    if (!function.FromPreset)
    {
      const std::string name = ChoosePreset(image, statistics).Name;
      function.FromPreset = std::make_shared<const Preset>(FindPreset(name, {}));
    }
    const TransferFunctionDescription preset =
      ScaleToVolume(*function.FromPreset, image, statistics);
    if (!function.Opacity)
    {
      function.Opacity = preset.Opacity;
      function.GradientOpacity =
        function.GradientOpacity ? function.GradientOpacity : preset.GradientOpacity;
      function.OpacityUnitDistance =
        function.OpacityUnitDistance ? function.OpacityUnitDistance : preset.OpacityUnitDistance;
    }
    function.Color = function.Color ? function.Color : preset.Color;
  }
  function.OpacityUnitDistance = function.OpacityUnitDistance.value_or(1.0);
}
}

//------------------------------------------------------------------------------
void ResolveScene(SceneDescription& scene, vtkImageData* image)
{
  ResolveSeries(scene.Volume.Series, image);
  ResolveTransferFunction(scene.TransferFunction, image);
  const double smallest = SmallestSpacing(image);
  scene.SampleDistance = scene.SampleDistance.value_or(0.5 * smallest);
  scene.Shadows.SampleDistance = scene.Shadows.SampleDistance.value_or(2.0 * *scene.SampleDistance);
  scene.Shadows.Technique = TechniqueChoice::Rays;
  for (LightDescription& light : scene.Lights)
  {
    light.ShadowBias = light.ShadowBias.value_or(smallest);
  }
  const auto& size = scene.Image.Size;
  ResolveCamera(
    scene.Camera, VolumeBox(image, scene.Volume.Transform), static_cast<double>(size[0]) / size[1]);
}

}
