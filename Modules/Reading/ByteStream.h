/**
 * @class   ByteStream
 * @brief   the bytes of a file from front to back, inflated if they are compressed
 */

#ifndef ByteStream_h
#define ByteStream_h

#include <cstdint>
#include <filesystem>
#include <memory>

namespace penumbra
{

class ByteStream
{
public:
  virtual ~ByteStream() = default;

  /**
   * Copies the next `size` bytes to `destination` and returns how many there were: fewer than
   * `size` only at the end. Throws VolumeReadingError where the file cannot be read or where
   * compressed data is cut short, damaged or followed by something else.
   */
  virtual std::uint64_t Read(void* destination, std::uint64_t size) = 0;

  /**
   * Moves on by `size` bytes; throws VolumeReadingError where there are fewer.
   */
  void Skip(std::uint64_t size);
};

/**
 * The bytes of `path` from `offset` on; where `compressed`, what the zlib or gzip stream that
 * begins there holds. Throws VolumeReadingError where the file cannot be opened.
 */
std::unique_ptr<ByteStream> OpenBytes(
  const std::filesystem::path& path, std::uint64_t offset, bool compressed);

/**
 * The bytes of `path` from `begin` to before `end`.
 */
std::unique_ptr<ByteStream> OpenPart(
  const std::filesystem::path& path, std::uint64_t begin, std::uint64_t end);

/**
 * The size of `path` in bytes. Throws VolumeReadingError where it does not exist, is no file or is
 * not accessible.
 */
std::uint64_t SizeOfFile(const std::filesystem::path& path);

}

#endif
