#include "ByteStream.h"

#include "VolumeReadingError.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <vector>

namespace penumbra
{

namespace
{

std::string Quoted(const std::filesystem::path& path)
{
  return "\"" + path.u8string() + "\"";
}

class FileBytes : public ByteStream
{
public:
  FileBytes(const std::filesystem::path& path, std::uint64_t offset)
    : File(path, std::ios::binary)
    , Name(Quoted(path))
  {
    if (!this->File)
    {
      throw VolumeReadingError(
        Name + " cannot be opened; a file that you are permitted to read is needed");
    }
    this->File.seekg(static_cast<std::streamoff>(offset));
  }

  std::uint64_t Read(void* destination, std::uint64_t size) override
  {
    this->File.read(static_cast<char*>(destination), static_cast<std::streamsize>(size));
    if (this->File.bad())
    {
      throw VolumeReadingError("reading " + this->Name + " failed; its disk may be damaged");
    }
    return static_cast<std::uint64_t>(this->File.gcount());
  }

private:
  std::ifstream File;
  std::string Name;
};

class PartOfFile : public ByteStream
{
public:
  PartOfFile(const std::filesystem::path& path, std::uint64_t begin, std::uint64_t end)
    : File(path, begin)
    , Remaining(end - begin)
  {
  }

  std::uint64_t Read(void* destination, std::uint64_t size) override
  {
    const std::uint64_t read = this->File.Read(destination, std::min(size, this->Remaining));
    this->Remaining -= read;
    return read;
  }

private:
  FileBytes File;
  std::uint64_t Remaining;
};

class InflatedBytes : public ByteStream
{
public:
  InflatedBytes(const std::filesystem::path& path, std::uint64_t offset)
    : Compressed(path, offset)
    , Input(1 << 16)
  {
    if (inflateInit2(&this->Inflater, DetectZlibOrGzip) != Z_OK)
    {
      throw VolumeReadingError("there is not enough memory to decompress it");
    }
  }
  ~InflatedBytes() override { inflateEnd(&this->Inflater); }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  std::uint64_t Read(void* destination, std::uint64_t size) override
  {
    // One call of inflate counts in unsigned int.
    constexpr std::uint64_t largestChunk = 1u << 30;
    this->Inflater.next_out = static_cast<Bytef*>(destination);
    std::uint64_t remaining = size;
    while (remaining > 0 && !this->Ended)
    {
      const uInt chunk = static_cast<uInt>(std::min(remaining, largestChunk));
      this->Inflater.avail_out = chunk;
      while (this->Inflater.avail_out > 0 && !this->Ended)
      {
        this->InflateSome();
      }
      remaining -= chunk - this->Inflater.avail_out;
    }
    return size - remaining;
  }

private:
  static constexpr int DetectZlibOrGzip = 15 + 32;

  bool FillInput()
  {
    if (this->Inflater.avail_in == 0)
    {
      this->Inflater.next_in = this->Input.data();
      this->Inflater.avail_in =
        static_cast<uInt>(this->Compressed.Read(this->Input.data(), this->Input.size()));
    }
    return this->Inflater.avail_in > 0;
  }

  void InflateSome()
  {
    if (!this->FillInput())
    {
      throw VolumeReadingError("its compressed data ends too early; the file is cut short");
    }
    const int result = inflate(&this->Inflater, Z_NO_FLUSH);
    if (result == Z_STREAM_END)
    {
      this->StartNextMemberOrEnd();
    }
    else if (result != Z_OK && result != Z_BUF_ERROR)
    {
      const std::string detail = this->Inflater.msg ? this->Inflater.msg : "unknown format";
      throw VolumeReadingError(
        "its compressed data is damaged or not zlib or gzip data (" + detail + ")");
    }
  }

  // A gzip file may hold several members one after the other.
  void StartNextMemberOrEnd()
  {
    constexpr Bytef firstByteOfGzip = 0x1f;
    this->Ended = !this->FillInput();
    if (!this->Ended && *this->Inflater.next_in != firstByteOfGzip)
    {
      throw VolumeReadingError(
        "its compressed data is followed by other bytes; it should end there");
    }
    if (!this->Ended)
    {
      inflateReset(&this->Inflater);
    }
  }

  FileBytes Compressed;
  std::vector<Bytef> Input;
  z_stream Inflater{};
  bool Ended = false;
};

}

void ByteStream::Skip(std::uint64_t size)
{
  std::array<char, 4096> skipped;
  while (size > 0)
  {
    const std::uint64_t step = std::min<std::uint64_t>(size, skipped.size());
    if (this->Read(skipped.data(), step) < step)
    {
      throw VolumeReadingError("it ends before its first voxel; the file is cut short");
    }
    size -= step;
  }
}

std::unique_ptr<ByteStream> OpenBytes(
  const std::filesystem::path& path, std::uint64_t offset, bool compressed)
{
  if (compressed)
  {
    return std::make_unique<InflatedBytes>(path, offset);
  }
  return std::make_unique<FileBytes>(path, offset);
}

std::unique_ptr<ByteStream> OpenPart(
  const std::filesystem::path& path, std::uint64_t begin, std::uint64_t end)
{
  return std::make_unique<PartOfFile>(path, begin, end);
}

std::uint64_t SizeOfFile(const std::filesystem::path& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
  {
    throw VolumeReadingError(Quoted(path) + " does not exist");
  }
  if (!error && status.type() != std::filesystem::file_type::regular)
  {
    throw VolumeReadingError(Quoted(path) + " is not a file");
  }
  const auto size = error ? 0 : std::filesystem::file_size(path, error);
  if (error)
  {
    throw VolumeReadingError(Quoted(path) + " is not accessible: " + error.message());
  }
  return size;
}

}
