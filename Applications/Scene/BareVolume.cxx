#include "BareVolume.h"

#include "BodyRegion.h"
#include "Preset.h"
#include "SceneDefaults.h"
#include "VisibleView.h"

#include <vtkImageData.h>

#include <sstream>

namespace penumbra
{
namespace
{
constexpr const char* AnyPreset = "surface";

std::string Rounded(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(4);
  text << number;
  return text.str();
}

SceneDescription DescribeWithPreset(const SceneSource& source, vtkImageData* image,
  const VolumeStatistics& statistics, std::vector<std::string>& choices)
{
  if (!source.IsPresetOpen())
  {
    return source.Describe(source.GetPreset());
  }
  // A setting may name the preset of the transfer function; lights and material then follow.
  const SceneDescription checked = source.Describe(AnyPreset);
  const auto& preset = checked.TransferFunction.FromPreset;
  if (!preset || preset->Name != AnyPreset)
  {
    return preset ? source.Describe(preset->Name) : checked;
  }
  const PresetChoice choice = ChoosePreset(image, statistics);
  choices.push_back("preset " + choice.Name + ": " + choice.Reason);
  return source.Describe(choice.Name);
}

void CropToBody(SceneDescription& scene, vtkImageData* image, std::vector<std::string>& choices)
{
  const auto& preset = scene.TransferFunction.FromPreset;
  if (!preset || !preset->CropMargin || scene.Volume.Cropping)
  {
    return;
  }
  scene.Volume.Cropping = FindBodyRegion(image, *preset->CropMargin);
  if (scene.Volume.Cropping)
  {
    const std::array<double, 6>& kept = *scene.Volume.Cropping;
    const auto along = [&kept](const char* axis, int low)
    { return std::string(axis) + " " + Rounded(kept[low]) + " to " + Rounded(kept[low + 1]); };
    choices.push_back("cropped to the body, which leaves out the table: " + along("x", 0) + ", " +
      along("y", 2) + ", " + along("z", 4) + " mm along the volume's own axes");
  }
}
}

//------------------------------------------------------------------------------
std::string PresetForChecking(const SceneSource& source)
{
  return source.IsPresetOpen() ? AnyPreset : source.GetPreset();
}

//------------------------------------------------------------------------------
SceneDescription ArrangeBareVolume(
  const SceneSource& source, vtkImageData* image, std::vector<std::string>& choices)
{
  const VolumeStatistics statistics(image);
  SceneDescription scene = DescribeWithPreset(source, image, statistics, choices);
  ResolveTransferFunction(scene.TransferFunction, image, statistics);
  CropToBody(scene, image, choices);
  const CameraDescription& camera = scene.Camera;
  if (!camera.Position && !camera.FocalPoint && !camera.ViewUp && !camera.ParallelScale)
  {
    choices.push_back(ViewFromTheFront(scene, image));
  }
  return scene;
}

}
