/**
 * @file    StudyScenes.h
 * @brief   the scenes that penumbra-study takes where none are named
 */

#ifndef StudyScenes_h
#define StudyScenes_h

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct StudyScene
{
  std::string Name;
  std::filesystem::path File;
};

/**
 * Writes volumes and scene files to `folder`: analytic ones of 64^3 voxels at 128x128 pixels, among
 * them a tree and a casting, and the CT that lies in `data`, where it does.
 * @throw std::runtime_error where a file cannot be written.
 */
std::vector<StudyScene> WriteDefaultScenes(
  const std::filesystem::path& folder, const std::filesystem::path& data);

/**
 * One of the analytic scenes by its name, with `edge` voxels along each edge of the same volume.
 * @throw std::runtime_error where a file cannot be written.
 */
StudyScene WriteAnalyticScene(
  const std::string& name, int edge, const std::filesystem::path& folder);

/// Scene files by their names; of two with one name, the second gets a number.
std::vector<StudyScene> NameScenes(const std::vector<std::filesystem::path>& files);

/// Writes a text file. @throw std::runtime_error where that fails.
void WriteText(const std::filesystem::path& file, const std::string& text);

}

#endif
