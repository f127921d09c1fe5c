/**
 * @class   MetaImageHeader
 * @brief   the fields of a MetaImage header, https://itk.org/Wiki/ITK/MetaIO/Documentation
 */

#ifndef MetaImageHeader_h
#define MetaImageHeader_h

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct VolumeGeometry;

struct MetaImageHeader
{
  std::map<std::string, std::string> fields;
  /// What follows ElementDataFile: where that is LIST, the names of the files.
  std::vector<std::string> listedFiles;
  /// Bytes up to the end of the line ElementDataFile.
  std::uint64_t size = 0;
  std::size_t numberOfAxes = 0;
  std::vector<std::string> lines;

  /**
   * The value of the first of these names that the header has.
   */
  std::optional<std::string> Value(const std::vector<std::string>& names) const;

  /**
   * The value; throws VolumeReadingError where the header lacks it.
   */
  std::string Needed(const std::string& name) const;

  bool IsTrue(const std::vector<std::string>& names) const;

  /**
   * The numbers of the first of these names that the header has; throws VolumeReadingError where
   * they are not as many as `otherwise`.
   */
  std::vector<double> Numbers(
    const std::vector<std::string>& names, const std::vector<double>& otherwise) const;

  /**
   * Whether the voxels follow the header in the same file.
   */
  bool IsLocal() const;
};

/**
 * Throws VolumeReadingError where the file does not begin with a MetaImage header.
 */
MetaImageHeader ReadMetaImageHeader(const std::filesystem::path& path);

/**
 * Dimensions, spacing, origin and direction. Throws VolumeReadingError where they are not those of
 * a volume.
 */
VolumeGeometry MetaImageGeometry(const MetaImageHeader& header);

}

#endif
