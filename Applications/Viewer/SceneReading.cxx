#include "SceneReading.h"

#include "BareVolume.h"
#include "SceneDefaults.h"
#include "SceneFile.h"

#include <vtkImageData.h>

namespace penumbra
{
namespace
{
// Dark, but not as dark as shadows are.
constexpr const char* Background = "image.background=[0.07,0.08,0.1]";

std::vector<std::string> SettingsOf(const OpenRequest& request)
{
  std::vector<std::string> settings;
  if (!IsSceneFile(request.File))
  {
    const auto& size = request.ViewSize;
    settings.push_back(
      "image.size=[" + std::to_string(size[0]) + "," + std::to_string(size[1]) + "]");
    settings.push_back(Background);
  }
  settings.insert(settings.end(), request.Settings.begin(), request.Settings.end());
  return settings;
}
}

//------------------------------------------------------------------------------
OpenedScene ReadScene(const OpenRequest& request, const VoxelReading& reading)
{
  const SceneSource source(request.File, SettingsOf(request));
  OpenedScene opened;
  opened.File = request.File;
  opened.Scene = source.Describe(PresetForChecking(source));
  opened.Voxels = ReadVoxels(opened.Scene.Volume, reading, opened.Warnings);
  if (source.IsBareVolume())
  {
    opened.Scene = ArrangeBareVolume(source, opened.Voxels.Volume, opened.Choices);
  }
  ResolveScene(opened.Scene, opened.Voxels.Volume);
  opened.Voxels.Environment = ReadEnvironmentImages(opened.Scene.Material);
  return opened;
}

}
