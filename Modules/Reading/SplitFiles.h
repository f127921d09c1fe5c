/**
 * @file    SplitFiles.h
 * @brief   volumes whose voxels are spread over several files
 *
 * MetaImage and NRRD can name such files one by one or by a pattern as "slice%03d.raw".
 */

#ifndef SplitFiles_h
#define SplitFiles_h

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * The names that `pattern`, which holds one "%d" with an optional width such as "%03d", gives for
 * first, first + step and so on to `last`. Throws VolumeReadingError where the pattern is another
 * or the numbers lead nowhere.
 */
std::vector<std::string> ExpandPattern(
  const std::string& pattern, std::int64_t first, std::int64_t last, std::int64_t step);

/**
 * The paths of `names`, which are relative to the folder of the file `header`. Throws
 * VolumeReadingError where one is missing.
 */
std::vector<std::filesystem::path> DataFiles(
  const std::filesystem::path& header, const std::vector<std::string>& names);

}

#endif
