/**
 * @file    SpeedScenes.h
 * @brief   the scenes that the speed study takes where none are named
 */

#ifndef SpeedScenes_h
#define SpeedScenes_h

#include "SpeedGrid.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct SpeedSceneList
{
  std::vector<SpeedScene> Scenes;
  /// Scenes that are left out, and why.
  std::vector<std::string> Notes;
};

/// Where scenes and volumes come from.
struct SpeedSceneSource
{
  /// Takes scene files and the volumes that are made.
  std::filesystem::path Folder;
  /// Has the scene files of fetched volumes in its folders thesis and speed.
  std::filesystem::path Data;
  /// Has the volumes themselves.
  std::filesystem::path Fetched;
  /// Voxels along each edge of volumes that are made.
  int Edge = 256;
};

/**
 * Writes the scenes of the fetched volumes that are there and of three that are made: a tree, a
 * casting, and haze, in which nothing is empty. Bounds are stated for five of the
 * fetched volumes; where none of them is there, those that are made stand in.
 * @throw std::runtime_error where a file cannot be written.
 */
SpeedSceneList WriteSpeedScenes(const SpeedSceneSource& source);

/// Scenes of one's own, with all axes and without bounds.
std::vector<SpeedScene> NameSpeedScenes(const std::vector<std::filesystem::path>& files);

}

#endif
