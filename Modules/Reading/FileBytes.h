/**
 * @file    FileBytes.h
 * @brief   bytes of a file, looked at before a reader of VTK gets to see it
 */

#ifndef FileBytes_h
#define FileBytes_h

#include <cstdint>
#include <filesystem>
#include <string>

namespace penumbra
{

/**
 * The size of `path` in bytes. Throws VolumeReadingError where it does not exist, is no file or is
 * not accessible.
 */
std::uint64_t SizeOfFile(const std::filesystem::path& path);

/**
 * `size` bytes of `path` from `offset` on, or fewer at the end. Throws VolumeReadingError where the
 * file cannot be read.
 */
std::string ReadBytes(const std::filesystem::path& path, std::uint64_t offset, std::uint64_t size);

enum class CompressedFormat
{
  Gzip, ///< which may have several members
  ZlibOrGzip
};

/**
 * Inflates what follows `offset` without keeping it. Throws VolumeReadingError where it is damaged,
 * followed by something else or not exactly `bytes` long: VTK's readers notice none of these for
 * certain.
 */
void CheckCompressed(const std::filesystem::path& path, std::uint64_t offset,
  CompressedFormat format, std::uint64_t bytes);

}

#endif
