/**
 * @class   XmlVoxels
 * @brief   the voxels of a VTK XML file: where they are and how they are written
 */

#ifndef XmlVoxels_h
#define XmlVoxels_h

#include <cstdint>
#include <filesystem>
#include <string>

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
  bool bigEndian = false;
  /// The size of the numbers that announce how many bytes follow: 4 or 8.
  std::size_t headerSize = 4;
  /// The class of VTK that compressed the voxels; empty where they are not compressed.
  std::string compressor;
};

/**
 * Throws VolumeReadingError where so few bytes cannot hold `count` voxels of `scalarType`.
 */
void CheckSize(const XmlVoxels& voxels, int scalarType, std::uint64_t count);

/**
 * Reads exactly `count` voxels of `scalarType` to `destination`, in the machine's byte order.
 * Throws VolumeReadingError where they are not there or damaged.
 */
void ReadXmlVoxels(const XmlVoxels& voxels, int scalarType, std::uint64_t count, void* destination);

}

#endif
