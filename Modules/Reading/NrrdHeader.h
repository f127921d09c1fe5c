/**
 * @class   NrrdHeader
 * @brief   the fields of a NRRD header, http://teem.sourceforge.net/nrrd/format.html
 */

#ifndef NrrdHeader_h
#define NrrdHeader_h

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct VolumeGeometry;

struct NrrdHeader
{
  /// By name in lower case and without blanks, as "spacedirections": NRRD knows both spellings of
  /// many fields.
  std::map<std::string, std::string> fields;
  /// The names of the data files where the field "data file" is LIST.
  std::vector<std::string> listedFiles;
  /// Bytes up to the end of the blank line that ends the header.
  std::uint64_t size = 0;

  std::optional<std::string> Value(const std::string& name) const;

  /**
   * The value; throws VolumeReadingError where the header lacks it.
   */
  std::string Needed(const std::string& name) const;

  /**
   * The words of a field that has one per axis; throws VolumeReadingError where it has not.
   */
  std::optional<std::vector<std::string>> WordsPerAxis(const std::string& name) const;

  /**
   * The field "dimension".
   */
  std::size_t NumberOfAxes() const;
};

/**
 * Throws VolumeReadingError where the file does not begin with a NRRD header.
 */
NrrdHeader ReadNrrdHeader(const std::filesystem::path& path);

/**
 * Dimensions, spacing, origin and direction in the file's own space. Throws VolumeReadingError
 * where they are not those of a volume of one value per voxel.
 */
VolumeGeometry NrrdGeometry(const NrrdHeader& header);

}

#endif
