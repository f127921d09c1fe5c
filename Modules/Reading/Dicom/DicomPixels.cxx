#include "DicomPixels.h"

#include "DicomStream.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"
#include "vtkByteSwap.h"

#include <gdcmByteValue.h>
#include <gdcmImage.h>
#include <gdcmImageReader.h>

#include <string>

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

// In Explicit VR Big Endian; of 8 bits, pixels may be written as pairs (DICOM PS3.5, 8.1.1).
void SwapBytes(std::vector<char>& bytes, int bitsAllocated, const gdcm::VR& type)
{
  if (bitsAllocated == 32)
  {
    vtkByteSwap::SwapVoidRange(bytes.data(), bytes.size() / 4, 4);
  }
  else if (bitsAllocated == 16 || type == gdcm::VR::OW)
  {
    vtkByteSwap::SwapVoidRange(bytes.data(), bytes.size() / 2, 2);
  }
}

// GDCM changes uncompressed pixels of which not all bits are stored, and ends the process over
// some.
DicomPixels TakeUncompressed(
  const gdcm::DataElement& element, const gdcm::TransferSyntax& syntax, const DicomImage& image)
{
  DicomPixels pixels;
  pixels.format = image.pixel;
  const std::size_t expected = BytesOf(image, image.pixel);
  const gdcm::ByteValue* value = element.GetByteValue();
  const std::size_t found = value ? static_cast<std::size_t>(value->GetLength()) : 0;
  if (found < expected)
  {
    throw VolumeReadingError("its pixels have " + std::to_string(found) + " bytes; " +
      std::to_string(expected) + " are needed");
  }
  const std::size_t even = expected + (found > expected ? expected % 2 : 0);
  pixels.bytes.assign(value->GetPointer(), value->GetPointer() + even);
  if (syntax.GetSwapCode() == gdcm::SwapCode::BigEndian)
  {
    SwapBytes(pixels.bytes, image.pixel.bitsAllocated, element.GetVR());
  }
  return pixels;
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
  DicomPixels pixels;
  pixels.format = FormatOf(decoded.GetPixelFormat());
  const std::size_t expected = BytesOf(image, pixels.format);
  if (pixels.format.bitsAllocated % 8 != 0 || decoded.GetBufferLength() != expected)
  {
    throw VolumeReadingError("its decoded pixels have " +
      std::to_string(decoded.GetBufferLength()) + " bytes; " + std::to_string(expected) +
      " are needed");
  }
  pixels.bytes.resize(expected);
  if (!decoded.GetBuffer(pixels.bytes.data()))
  {
    throw VolumeReadingError("its pixels cannot be decoded");
  }
  return pixels;
}

}

DicomPixels ReadDicomPixels(const std::filesystem::path& path, const DicomImage& image)
{
  gdcm::Reader reader;
  const DicomStream stream(path, reader);
  if (!reader.Read())
  {
    throw VolumeReadingError("it is damaged");
  }
  stream.ThrowIfCutShort();
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  if (!data.FindDataElement(DicomTags::PixelData))
  {
    throw VolumeReadingError("it has no pixels");
  }
  const gdcm::DataElement& element = data.GetDataElement(DicomTags::PixelData);
  const gdcm::TransferSyntax& syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  return IsCompressed(element, syntax) ? Decompress(path, image)
                                       : TakeUncompressed(element, syntax, image);
}

}
