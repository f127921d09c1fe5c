#include "DicomStream.h"

#include "DicomFiles.h"
#include "VolumeReadingError.h"

#include <gdcmTrace.h>

namespace penumbra
{

namespace
{

// At its end, a whole file is asked for one more tag and gives nothing.
constexpr std::streamsize LargestTagRead = 4;

}

std::streamsize DicomStream::Buffer::xsgetn(char* bytes, std::streamsize count)
{
  const std::streamsize got = std::filebuf::xsgetn(bytes, count);
  this->IsCutShort = this->IsCutShort || (got < count && (got > 0 || count > LargestTagRead));
  return got;
}

DicomStream::DicomStream(const std::filesystem::path& path, gdcm::Reader& reader)
  : Stream(&this->File)
{
  if (!MayBeDicom(path))
  {
    throw VolumeReadingError("it does not start as DICOM files do");
  }
  this->File.open(path, std::ios::in | std::ios::binary);
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  reader.SetStream(this->Stream);
}

void DicomStream::ThrowIfCutShort() const
{
  if (this->File.IsCutShort)
  {
    throw VolumeReadingError("it is cut short");
  }
}

}
