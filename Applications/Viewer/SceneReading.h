/**
 * @file    SceneReading.h
 * @brief   a scene or a volume as the viewer opens it
 */

#ifndef SceneReading_h
#define SceneReading_h

#include "SceneDescription.h"
#include "SceneVolume.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct OpenRequest
{
  /// A scene file, a volume or a DICOM folder.
  std::filesystem::path File;
  /// Keys of the scene that the file does not say itself, as penumbra-render's --set takes them:
  /// the geometry of a .raw file, the series of a DICOM folder.
  std::vector<std::string> Settings;
  /// Whether to ask for a series where a folder holds several, of which else the largest is read.
  bool AskForSeries = false;
  /// Of the view, in pixels: a volume without a scene fills it.
  std::array<int, 2> ViewSize = { 512, 512 };
};

struct OpenedScene
{
  /// What was asked for.
  std::filesystem::path File;
  /// Resolved.
  SceneDescription Scene;
  SceneVoxels Voxels;
  /// What was chosen for a volume without a scene, and what a user should know of the data.
  ///@{
  std::vector<std::string> Choices;
  std::vector<std::string> Warnings;
  ///@}
};

/**
 * Reads scene and voxels as penumbra-render does. May run in any thread.
 * @throw InputError where they cannot be read.
 */
OpenedScene ReadScene(const OpenRequest& request, const VoxelReading& reading);

}

#endif
