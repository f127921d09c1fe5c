#include "DicomPixels.h"

#include "DicomStream.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"
#include "vtkByteSwap.h"

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

// What is stored with the most significant byte first. 8 bits may be written as words of two pixels
// (DICOM PS3.5, 8.1.1).
void TurnBytes(std::vector<char>& bytes, int bitsAllocated, bool isWords)
{
  const std::size_t size = bitsAllocated == 32 ? 4 : bitsAllocated == 16 || isWords ? 2 : 1;
  switch (size)
  {
    case 4:
      vtkByteSwap::Swap4BERange(bytes.data(), bytes.size() / size);
      break;
    case 2:
      vtkByteSwap::Swap2BERange(bytes.data(), bytes.size() / size);
      break;
    default:
      break;
  }
}

// GDCM changes pixels of which not all bits are stored, and ends the process over some, so
// uncompressed ones are taken from the file. They follow what it has read.
DicomPixels TakeUncompressed(
  DicomStream& stream, const gdcm::TransferSyntax& syntax, const DicomImage& image)
{
  // GE's private syntax is Implicit VR Little Endian but for the pixels.
  const bool isBigEndian = syntax == gdcm::TransferSyntax::ExplicitVRBigEndian ||
    syntax == gdcm::TransferSyntax::ImplicitVRBigEndianPrivateGE;
  const DicomPixelElement element = stream.ReadPixelElement(syntax);
  const std::size_t expected = BytesOf(image, image.pixel);
  if (element.length < expected)
  {
    throw VolumeReadingError("its pixels have " + std::to_string(element.length) + " bytes; " +
      std::to_string(expected) + " are needed");
  }
  // Words of two pixels may end with half of one.
  DicomPixels pixels{ image.pixel, std::vector<char>(expected + expected % 2) };
  stream.Read(pixels.bytes.data(), std::min<std::size_t>(pixels.bytes.size(), element.length));
  if (isBigEndian)
  {
    TurnBytes(pixels.bytes, image.pixel.bitsAllocated, element.isWords);
  }
  return pixels;
}

DicomPixels Inflate(const std::filesystem::path& path, const DicomImage& image)
{
  gdcm::Reader reader;
  const DicomStream stream(path, reader);
  const bool isRead = reader.ReadUpToTag(DicomTags::PixelData);
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  const gdcm::ByteValue* value = isRead && data.FindDataElement(DicomTags::PixelData)
    ? data.GetDataElement(DicomTags::PixelData).GetByteValue()
    : nullptr;
  const std::size_t expected = BytesOf(image, image.pixel);
  if (!value || static_cast<std::size_t>(value->GetLength()) < expected)
  {
    throw VolumeReadingError("its pixels cannot be inflated");
  }
  return { image.pixel, std::vector<char>(value->GetPointer(), value->GetPointer() + expected) };
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
  if (!format.IsUsable())
  {
    throw VolumeReadingError("its pixels decode to " + std::to_string(format.bitsStored) + " of " +
      std::to_string(format.bitsAllocated) + " bits, which are not read");
  }
  const std::size_t expected = BytesOf(image, format);
  if (decoded.GetBufferLength() != expected)
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
  return { format, std::move(bytes) };
}

}

DicomPixels ReadDicomPixels(const std::filesystem::path& path, const DicomImage& image)
{
  gdcm::Reader reader;
  DicomStream stream(path, reader);
  if (!reader.ReadUpToTag(DicomTags::PixelData, { DicomTags::PixelData }))
  {
    throw VolumeReadingError("it is damaged");
  }
  const gdcm::TransferSyntax& syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  if (syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian)
  {
    return Inflate(path, image);
  }
  return syntax.IsEncapsulated() ? Decompress(path, image)
                                 : TakeUncompressed(stream, syntax, image);
}

}
