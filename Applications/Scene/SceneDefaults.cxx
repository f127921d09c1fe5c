#include "SceneDefaults.h"

#include "Preset.h"
#include "SceneCamera.h"
#include "VolumeBox.h"
#include "VolumeFields.h"

namespace penumbra
{
//------------------------------------------------------------------------------
void ResolveTransferFunction(
  TransferFunctionDescription& function, vtkImageData* image, const VolumeStatistics& statistics)
{
  if (!function.Opacity || !function.Color)
  {
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
}

//------------------------------------------------------------------------------
void ResolveScene(SceneDescription& scene, vtkImageData* image)
{
  const std::string series = TextField(image, "SeriesInstanceUID");
  if (!series.empty())
  {
    scene.Volume.Series = series;
  }
  TransferFunctionDescription& function = scene.TransferFunction;
  if (!function.Opacity || !function.Color)
  {
    ResolveTransferFunction(function, image, VolumeStatistics(image));
  }
  function.OpacityUnitDistance = function.OpacityUnitDistance.value_or(1.0);
  const double smallest = SmallestSpacing(image);
  scene.SampleDistance = scene.SampleDistance.value_or(0.5 * smallest);
  scene.Shadows.SampleDistance = scene.Shadows.SampleDistance.value_or(2.0 * *scene.SampleDistance);
  for (LightDescription& light : scene.Lights)
  {
    light.ShadowBias = light.ShadowBias.value_or(smallest);
  }
  const auto& size = scene.Image.Size;
  ResolveCamera(
    scene.Camera, VolumeBox(image, scene.Volume.Transform), static_cast<double>(size[0]) / size[1]);
}

}
