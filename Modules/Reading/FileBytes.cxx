#include "FileBytes.h"

#include "VolumeReadingError.h"
#include "vtk_zlib.h"

#include <algorithm>
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

std::ifstream Opened(const std::filesystem::path& path, std::uint64_t offset)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw VolumeReadingError(
      Quoted(path) + " cannot be opened; a file that you are permitted to read is needed");
  }
  file.seekg(static_cast<std::streamoff>(offset));
  return file;
}

std::size_t Read(std::ifstream& file, const std::filesystem::path& path, char* to, std::size_t size)
{
  file.read(to, static_cast<std::streamsize>(size));
  if (file.bad())
  {
    throw VolumeReadingError("reading " + Quoted(path) + " failed; its disk may be damaged");
  }
  return static_cast<std::size_t>(file.gcount());
}

class Inflater
{
public:
  Inflater(const std::filesystem::path& path, std::uint64_t offset, CompressedFormat format)
    : Path(path)
    , File(Opened(path, offset))
    , AllowsMembers(format == CompressedFormat::Gzip)
    , Input(1 << 16)
    , Output(1 << 16)
  {
    // zlib's window of 15 bits, plus 16 for gzip or 32 to tell by the first bytes.
    if (inflateInit2(&this->Stream, format == CompressedFormat::Gzip ? 15 + 16 : 15 + 32) != Z_OK)
    {
      throw VolumeReadingError("there is not enough memory to decompress it");
    }
  }
  ~Inflater() { inflateEnd(&this->Stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Inflates some and returns how many bytes came out.
  std::uint64_t Step()
  {
    if (!this->FillInput())
    {
      throw VolumeReadingError("its compressed data ends too early; the file is cut short");
    }
    this->Stream.next_out = this->Output.data();
    this->Stream.avail_out = static_cast<uInt>(this->Output.size());
    const int result = inflate(&this->Stream, Z_NO_FLUSH);
    if (result == Z_STREAM_END)
    {
      this->StartNextMemberOrEnd();
    }
    else if (result != Z_OK && result != Z_BUF_ERROR)
    {
      const std::string detail = this->Stream.msg ? this->Stream.msg : "unknown format";
      throw VolumeReadingError("its compressed data is damaged or not " +
        std::string(this->AllowsMembers ? "gzip" : "zlib or gzip") + " data (" + detail + ")");
    }
    return this->Output.size() - this->Stream.avail_out;
  }

  bool HasEnded() const { return this->Ended; }

private:
  bool FillInput()
  {
    if (this->Stream.avail_in == 0)
    {
      this->Stream.next_in = this->Input.data();
      this->Stream.avail_in = static_cast<uInt>(Read(
        this->File, this->Path, reinterpret_cast<char*>(this->Input.data()), this->Input.size()));
    }
    return this->Stream.avail_in > 0;
  }

  void StartNextMemberOrEnd()
  {
    constexpr Bytef firstByteOfGzip = 0x1f;
    this->Ended = !this->FillInput();
    if (this->Ended)
    {
      return;
    }
    if (!this->AllowsMembers || *this->Stream.next_in != firstByteOfGzip)
    {
      throw VolumeReadingError(
        "its compressed data is followed by other bytes; it should end there");
    }
    inflateReset(&this->Stream);
  }

  const std::filesystem::path& Path;
  std::ifstream File;
  bool AllowsMembers;
  std::vector<Bytef> Input;
  std::vector<Bytef> Output;
  z_stream Stream{};
  bool Ended = false;
};

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

std::string ReadBytes(const std::filesystem::path& path, std::uint64_t offset, std::uint64_t size)
{
  std::ifstream file = Opened(path, offset);
  const std::uint64_t present = SizeOfFile(path);
  std::string bytes(std::min(size, present - std::min(offset, present)), '\0');
  bytes.resize(Read(file, path, bytes.data(), bytes.size()));
  return bytes;
}

void CheckCompressed(const std::filesystem::path& path, std::uint64_t offset,
  CompressedFormat format, std::uint64_t bytes)
{
  Inflater inflater(path, offset, format);
  std::uint64_t present = 0;
  while (!inflater.HasEnded() && present <= bytes)
  {
    present += inflater.Step();
  }
  if (present != bytes)
  {
    throw VolumeReadingError("its compressed data " +
      (present > bytes ? "goes on" : "ends after " + std::to_string(present) + " bytes") +
      ", but exactly " + std::to_string(bytes) + " bytes are needed uncompressed");
  }
}

}
