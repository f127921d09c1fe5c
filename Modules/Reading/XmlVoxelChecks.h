/**
 * @file    XmlVoxelChecks.h
 * @brief   where the voxels of a VTK XML file are, and whether they can be read
 */

#ifndef XmlVoxelChecks_h
#define XmlVoxelChecks_h

#include <cstdint>
#include <filesystem>

namespace penumbra
{

struct XmlVoxels
{
  std::filesystem::path file;
  /// The bytes of the file among which the voxels are.
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
  bool isText = false;
  bool isBase64 = false;
  bool isCompressed = false;
  bool bigEndian = false;
  /// The size of the numbers that announce how many bytes follow: 4 or 8.
  std::size_t headerSize = 4;
};

/**
 * Throws VolumeReadingError where the bytes are not `count` voxels of `scalarType`. VTK's reader
 * allocates what they announce, divides by it, and takes data that ends early for whole.
 */
void CheckXmlVoxels(const XmlVoxels& voxels, int scalarType, std::uint64_t count);

/**
 * Where `letter` is in the file from `begin` on; throws VolumeReadingError where it is not.
 */
std::uint64_t PositionOf(char letter, const std::filesystem::path& file, std::uint64_t begin);

}

#endif
