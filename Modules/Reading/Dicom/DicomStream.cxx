#include "DicomStream.h"

#include "DicomFiles.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"

#include <gdcmTrace.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string>

namespace penumbra
{

namespace
{

constexpr std::size_t WindowSize = 65536;

// At its end, a whole file is asked for one more tag and gives nothing.
constexpr std::streamsize LargestTagRead = 4;

// Its flags are one for all threads.
void SilenceGDCM()
{
  static std::once_flag once;
  std::call_once(once,
    []
    {
      gdcm::Trace::WarningOff();
      gdcm::Trace::ErrorOff();
    });
}

}

DicomStream::Buffer::Buffer()
  : Window(WindowSize)
{
}

bool DicomStream::Buffer::Open(const std::filesystem::path& path)
{
  std::error_code ignored;
  const bool isFile = std::filesystem::is_regular_file(path, ignored); // a pipe is waited for
  if (!isFile || !this->File.open(path, std::ios::in | std::ios::binary))
  {
    return false;
  }
  this->FileSize = this->File.pubseekoff(0, std::ios::end, std::ios::in);
  return this->FileSize >= 0;
}

DicomStream::Buffer::int_type DicomStream::Buffer::underflow()
{
  this->WindowStart = this->Position();
  this->File.pubseekpos(this->WindowStart, std::ios::in);
  const std::streamsize count =
    this->File.sgetn(this->Window.data(), static_cast<std::streamsize>(this->Window.size()));
  this->setg(this->Window.data(), this->Window.data(), this->Window.data() + count);
  return count > 0 ? traits_type::to_int_type(*this->gptr()) : traits_type::eof();
}

std::streamsize DicomStream::Buffer::TakeFromWindow(char* bytes, std::streamsize count)
{
  const std::streamsize taken = std::min<std::streamsize>(count, this->egptr() - this->gptr());
  std::copy_n(this->gptr(), taken, bytes);
  this->setg(this->eback(), this->gptr() + taken, this->egptr());
  return taken;
}

std::streamsize DicomStream::Buffer::xsgetn(char* bytes, std::streamsize count)
{
  std::streamsize got = this->TakeFromWindow(bytes, count);
  if (count - got >= static_cast<std::streamsize>(this->Window.size()))
  {
    this->File.pubseekpos(this->Position(), std::ios::in);
    got += this->File.sgetn(bytes + got, count - got);
    this->seekoff(
      this->File.pubseekoff(0, std::ios::cur, std::ios::in), std::ios::beg, std::ios::in);
  }
  while (got < count && !traits_type::eq_int_type(this->underflow(), traits_type::eof()))
  {
    got += this->TakeFromWindow(bytes + got, count - got);
  }
  this->CutShort = this->CutShort || (got < count && (got > 0 || count > LargestTagRead));
  return got;
}

DicomStream::Buffer::pos_type DicomStream::Buffer::seekoff(
  off_type offset, std::ios::seekdir from, std::ios::openmode)
{
  const off_type start = from == std::ios::beg ? 0
    : from == std::ios::cur                    ? this->Position()
                                               : this->FileSize;
  const off_type target = start + offset;
  if (target < 0 || target > this->FileSize)
  {
    this->CutShort = true;
    return pos_type(off_type(-1));
  }
  const off_type within = target - this->WindowStart;
  if (within >= 0 && within <= this->egptr() - this->eback())
  {
    this->setg(this->eback(), this->eback() + within, this->egptr());
  }
  else
  {
    this->WindowStart = target;
    this->setg(this->Window.data(), this->Window.data(), this->Window.data());
  }
  return target;
}

DicomStream::Buffer::pos_type DicomStream::Buffer::seekpos(
  pos_type position, std::ios::openmode which)
{
  return this->seekoff(position, std::ios::beg, which);
}

DicomStream::DicomStream(const std::filesystem::path& path, gdcm::Reader& reader)
  : Stream(&this->Bytes)
{
  if (!this->Bytes.Open(path))
  {
    throw VolumeReadingError("it cannot be opened");
  }
  if (!MayBeDicom(path))
  {
    throw VolumeReadingError("it does not start as DICOM files do");
  }
  SilenceGDCM();
  reader.SetStream(this->Stream);
}

std::uint64_t DicomStream::GetSize() const
{
  return static_cast<std::uint64_t>(this->Bytes.GetSize());
}

DicomPixelElement DicomStream::ReadPixelElement(const gdcm::TransferSyntax& syntax)
{
  // Tag, type and length, or where types are implicit, tag and length behind the end of something
  // else. Not all files keep to what their syntax says of types.
  std::array<unsigned char, 12> head{};
  this->Stream.clear();
  this->Stream.seekg(-static_cast<std::streamoff>(head.size()), std::ios::cur);
  this->Read(reinterpret_cast<char*>(head.data()), head.size());
  const bool isBig = syntax.GetSwapCode() == gdcm::SwapCode::BigEndian;
  const auto number = [&head, isBig](std::size_t at, std::size_t count)
  {
    std::uint32_t value = 0;
    for (std::size_t index = 0; index < count; ++index)
    {
      value = value << 8 | head[at + (isBig ? index : count - 1 - index)];
    }
    return value;
  };
  const auto isPixelData = [&number](std::size_t at)
  {
    return number(at, 2) == DicomTags::PixelData.GetGroup() &&
      number(at + 2, 2) == DicomTags::PixelData.GetElement();
  };
  const bool isExplicit = isPixelData(0) && (head[4] == 'O' || head[4] == 'U');
  if (!isExplicit && !isPixelData(4))
  {
    throw VolumeReadingError("it has no pixels");
  }
  const std::uint64_t length = number(8, 4);
  const auto rest = this->GetSize() - static_cast<std::uint64_t>(this->Stream.tellg());
  if (length > rest)
  {
    throw VolumeReadingError("it is cut short: its pixels have " + std::to_string(rest) +
      " bytes of " + std::to_string(length));
  }
  return { length, isExplicit && head[5] == 'W' };
}

void DicomStream::Read(char* bytes, std::size_t count)
{
  if (!this->Stream.read(bytes, static_cast<std::streamsize>(count)))
  {
    throw VolumeReadingError("it is cut short");
  }
}

void DicomStream::ThrowIfCutShort() const
{
  if (this->Bytes.IsCutShort())
  {
    throw VolumeReadingError("it is cut short");
  }
}

}
