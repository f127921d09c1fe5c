#include "DicomPixels.h"

#include "DicomStream.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"

#include <gdcmByteValue.h>
#include <gdcmImage.h>
#include <gdcmImageReader.h>

#include <algorithm>
#include <string>
#include <utility>

namespace penumbra
{

namespace
{

std::string InWords(std::size_t columns, std::size_t rows, std::size_t frames)
{
  return std::to_string(columns) + "x" + std::to_string(rows) + "x" + std::to_string(frames);
}

std::size_t BytesOf(const DicomImage& image, const DicomPixelFormat& pixel)
{
  return static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows) *
    image.frames.size() * static_cast<std::size_t>(pixel.bitsAllocated / 8);
}

void CheckSize(const gdcm::Image& decoded, const DicomImage& image)
{
  const unsigned int frames = decoded.GetNumberOfDimensions() == 3 ? decoded.GetDimension(2) : 1;
  const std::string found = InWords(decoded.GetDimension(0), decoded.GetDimension(1), frames);
  const std::string expected = InWords(image.columns, image.rows, image.frames.size());
  if (found != expected)
  {
    throw VolumeReadingError(
      "its pixels are " + found + ", but its header says that they are " + expected);
  }
  if (decoded.GetPixelFormat().GetSamplesPerPixel() != 1)
  {
    throw VolumeReadingError("its pixels are colours; one of grey values is needed");
  }
}

DicomPixelFormat FormatOf(const gdcm::PixelFormat& decoded)
{
  DicomPixelFormat format;
  format.bitsAllocated = decoded.GetBitsAllocated();
  format.bitsStored = decoded.GetBitsStored();
  format.highBit = decoded.GetHighBit();
  format.isSigned = decoded.GetPixelRepresentation() == 1;
  return format;
}

bool IsCompressed(const gdcm::DataElement& element, const gdcm::TransferSyntax& syntax)
{
  return element.GetSequenceOfFragments() || syntax.IsEncapsulated();
}

// GDCM has turned the bytes of each 16 bits of Explicit VR Big Endian, which leaves 32 bits with
// their halves exchanged.
std::vector<char> ExchangeHalves(const char* bytes, std::size_t count)
{
  std::vector<char> exchanged(count);
  for (std::size_t at = 0; at + 4 <= count; at += 4)
  {
    std::copy_n(bytes + at, 2, exchanged.data() + at + 2);
    std::copy_n(bytes + at + 2, 2, exchanged.data() + at);
  }
  return exchanged;
}

// GDCM changes uncompressed pixels of which not all bits are stored, and ends the process over
// some.
DicomPixels TakeUncompressed(
  const gdcm::DataElement& element, const gdcm::TransferSyntax& syntax, const DicomImage& image)
{
  const std::size_t expected = BytesOf(image, image.pixel);
  const gdcm::ByteValue* value = element.GetByteValue();
  const std::size_t found = value ? static_cast<std::size_t>(value->GetLength()) : 0;
  if (found < expected)
  {
    throw VolumeReadingError("its pixels have " + std::to_string(found) + " bytes; " +
      std::to_string(expected) + " are needed");
  }
  const bool isBigEndian = syntax.GetSwapCode() == gdcm::SwapCode::BigEndian;
  if (isBigEndian && image.pixel.bitsAllocated == 32)
  {
    return DicomPixels(image.pixel, ExchangeHalves(value->GetPointer(), expected));
  }
  return DicomPixels(image.pixel, element);
}

DicomPixels Decompress(const std::filesystem::path& path, const DicomImage& image)
{
  gdcm::ImageReader reader;
  const DicomStream stream(path, reader);
  if (!reader.Read())
  {
    throw VolumeReadingError("its pixels are damaged or of a kind that is not read");
  }
  stream.ThrowIfCutShort();
  const gdcm::Image& decoded = reader.GetImage();
  CheckSize(decoded, image);
  const DicomPixelFormat format = FormatOf(decoded.GetPixelFormat());
  const std::size_t expected = BytesOf(image, format);
  if (format.bitsAllocated % 8 != 0 || decoded.GetBufferLength() != expected)
  {
    throw VolumeReadingError("its decoded pixels have " +
      std::to_string(decoded.GetBufferLength()) + " bytes; " + std::to_string(expected) +
      " are needed");
  }
  std::vector<char> bytes(expected);
  if (!decoded.GetBuffer(bytes.data()))
  {
    throw VolumeReadingError("its pixels cannot be decoded");
  }
  return DicomPixels(format, std::move(bytes));
}

}

DicomPixels::DicomPixels(const DicomPixelFormat& format, const gdcm::DataElement& element)
  : Format(format)
  , Stored(element)
{
}

DicomPixels::DicomPixels(const DicomPixelFormat& format, std::vector<char> bytes)
  : Format(format)
  , Decoded(std::move(bytes))
{
}

const char* DicomPixels::GetBytes() const
{
  return this->Decoded.empty() ? this->Stored.GetByteValue()->GetPointer() : this->Decoded.data();
}

DicomPixels ReadDicomPixels(const std::filesystem::path& path, const DicomImage& image)
{
  gdcm::Reader reader;
  const DicomStream stream(path, reader);
  if (!reader.ReadUpToTag(DicomTags::PixelData))
  {
    throw VolumeReadingError("it is damaged");
  }
  const gdcm::TransferSyntax& syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  // What inflates the file asks for more than it has.
  if (syntax != gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian)
  {
    stream.ThrowIfCutShort();
  }
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  if (!data.FindDataElement(DicomTags::PixelData))
  {
    throw VolumeReadingError("it has no pixels");
  }
  const gdcm::DataElement& element = data.GetDataElement(DicomTags::PixelData);
  return IsCompressed(element, syntax) ? Decompress(path, image)
                                       : TakeUncompressed(element, syntax, image);
}

}
