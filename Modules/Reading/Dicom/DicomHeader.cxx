#include "DicomHeader.h"

#include "DicomDataSet.h"
#include "DicomFrames.h"
#include "DicomStream.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"

#include <gdcmReader.h>
#include <gdcmUIDs.h>

#include <algorithm>

namespace penumbra
{

namespace
{

std::string KindOf(const DicomDataSet& data)
{
  gdcm::UIDs kinds;
  const std::string uid = data.Text(DicomTags::SOPClassUID);
  const char* name = kinds.SetFromUID(uid.c_str()) ? kinds.GetName() : nullptr;
  return name ? name : uid.empty() ? "DICOM object of no kind" : "DICOM object of kind " + uid;
}

void RefuseWhatIsNoImage(const DicomDataSet& data)
{
  if (data.Has(DicomTags::DirectoryRecordSequence))
  {
    throw VolumeReadingError("it is a directory of DICOM files, not an image");
  }
  if (!data.Has(DicomTags::Rows) || !data.Has(DicomTags::Columns))
  {
    throw VolumeReadingError("it holds no image: it is a " + KindOf(data));
  }
}

void RefuseColours(const DicomDataSet& data, const std::string& photometric)
{
  const std::uint32_t samples = data.Integer(DicomTags::SamplesPerPixel).value_or(1);
  if (samples != 1 || photometric.rfind("MONOCHROME", 0) != 0)
  {
    throw VolumeReadingError("it is a colour image (" +
      (photometric.empty() ? "without Photometric Interpretation" : photometric) + ", " +
      std::to_string(samples) + " samples per pixel); one of grey values is needed");
  }
}

int SmallInteger(const DicomDataSet& data, const gdcm::Tag& tag, int absent)
{
  const auto value = data.Integer(tag);
  return value ? static_cast<int>(std::min<std::uint32_t>(*value, 65535)) : absent;
}

void RefuseOtherPixels(const DicomDataSet& data, const DicomPixelFormat& pixel)
{
  if (data.Has(DicomTags::FloatPixelData) || data.Has(DicomTags::DoubleFloatPixelData))
  {
    throw VolumeReadingError("its pixels are floating point numbers, which are not read");
  }
  if (pixel.bitsAllocated == 1)
  {
    throw VolumeReadingError("its pixels have one bit: it is a " + KindOf(data));
  }
  if (!pixel.IsUsable())
  {
    throw VolumeReadingError("its pixels have " + std::to_string(pixel.bitsStored) + " of " +
      std::to_string(pixel.bitsAllocated) + " bits up to bit " + std::to_string(pixel.highBit) +
      "; 8, 16 or 32 bits are needed and what is stored within them");
  }
  if (SmallInteger(data, DicomTags::PixelRepresentation, 0) > 1)
  {
    throw VolumeReadingError("its Pixel Representation is neither 0 nor 1");
  }
  if (data.Items(DicomTags::ModalityLUTSequence).Size() > 0)
  {
    throw VolumeReadingError("its values go through a Modality LUT, which is not read");
  }
}

void RefuseMosaics(const DicomDataSet& data)
{
  if (data.Text(DicomTags::ImageType).find("MOSAIC") != std::string::npos)
  {
    throw VolumeReadingError("it is a mosaic, whose tiles are slices; split it into slices first");
  }
}

DicomPixelFormat ReadPixelFormat(const DicomDataSet& data)
{
  DicomPixelFormat pixel;
  pixel.bitsAllocated = SmallInteger(data, DicomTags::BitsAllocated, 16);
  pixel.bitsStored = SmallInteger(data, DicomTags::BitsStored, pixel.bitsAllocated);
  pixel.highBit = SmallInteger(data, DicomTags::HighBit, pixel.bitsStored - 1);
  pixel.isSigned = SmallInteger(data, DicomTags::PixelRepresentation, 0) == 1;
  return pixel;
}

// The value's bits are those of a pixel, whatever type they are written with.
std::int64_t AsPixel(std::uint32_t bits, const DicomPixelFormat& pixel)
{
  if (!pixel.isSigned)
  {
    return bits;
  }
  return pixel.bitsAllocated == 32 ? static_cast<std::int32_t>(bits)
                                   : static_cast<std::int16_t>(bits);
}

std::optional<std::array<std::int64_t, 2>> ReadPadding(
  const DicomDataSet& data, const DicomPixelFormat& pixel)
{
  const auto value = data.Integer(DicomTags::PixelPaddingValue);
  if (!value)
  {
    return std::nullopt;
  }
  const std::int64_t first = AsPixel(*value, pixel);
  const auto limit = data.Integer(DicomTags::PixelPaddingRangeLimit);
  const std::int64_t last = limit ? AsPixel(*limit, pixel) : first;
  return std::array<std::int64_t, 2>{ std::min(first, last), std::max(first, last) };
}

// US stands for "unspecified" (DICOM PS3.3, C.11.1.1.2).
std::string StatedType(const DicomDataSet& data)
{
  const std::string type = data.Text(DicomTags::RescaleType);
  return type == "US" || type.find("UNITLESS") != std::string::npos ? "" : type;
}

std::string ReadUnits(const DicomDataSet& data, const std::string& modality)
{
  if (!StatedType(data).empty())
  {
    return StatedType(data);
  }
  for (const auto& tag : { DicomTags::SharedFunctionalGroups, DicomTags::PerFrameFunctionalGroups })
  {
    const auto groups = data.Items(tag);
    const auto values = groups.Size() > 0
      ? groups.Item(0).Items(DicomTags::PixelValueTransformationSequence)
      : DicomDataSet::Sequence();
    if (values.Size() > 0 && !StatedType(values.Item(0)).empty())
    {
      return StatedType(values.Item(0));
    }
  }
  const std::string units = data.Text(DicomTags::Units);
  if (!units.empty())
  {
    return units;
  }
  const std::string dose = data.Text(DicomTags::DoseUnits);
  if (!dose.empty())
  {
    return dose;
  }
  return modality == "CT" && data.Has(DicomTags::RescaleIntercept) ? "HU" : "";
}

// Values of these modalities are measurements even where the file names no unit.
bool HasUnit(const DicomImage& image)
{
  return !image.units.empty() || image.modality == "CT" || image.modality == "PT" ||
    image.modality == "RTDOSE";
}

void ReadNames(const DicomDataSet& data, DicomImage& image)
{
  image.seriesInstanceUID = data.Text(DicomTags::SeriesInstanceUID);
  image.studyInstanceUID = data.Text(DicomTags::StudyInstanceUID);
  image.frameOfReferenceUID = data.Text(DicomTags::FrameOfReferenceUID);
  image.seriesNumber = data.Text(DicomTags::SeriesNumber);
  image.seriesDescription = data.Text(DicomTags::SeriesDescription);
  image.modality = data.Text(DicomTags::Modality);
}

DicomImage ReadImage(const DicomDataSet& data, std::uint64_t fileSize)
{
  RefuseWhatIsNoImage(data);
  DicomImage image;
  ReadNames(data, image);
  image.units = ReadUnits(data, image.modality);
  image.rows = SmallInteger(data, DicomTags::Rows, 0);
  image.columns = SmallInteger(data, DicomTags::Columns, 0);
  if (image.rows < 1 || image.columns < 1)
  {
    throw VolumeReadingError("it has " + std::to_string(image.rows) + " rows and " +
      std::to_string(image.columns) + " columns");
  }
  const std::string photometric = data.Text(DicomTags::PhotometricInterpretation);
  RefuseColours(data, photometric);
  image.isInverted = photometric == "MONOCHROME1";
  image.isTurnedOver = image.isInverted && !HasUnit(image);
  image.pixel = ReadPixelFormat(data);
  RefuseOtherPixels(data, image.pixel);
  RefuseMosaics(data);
  image.padding = ReadPadding(data, image.pixel);
  image.frames = ReadDicomFrames(data, fileSize);
  return image;
}

}

DicomImage ReadDicomHeader(const std::filesystem::path& path)
{
  gdcm::Reader reader;
  DicomStream stream(path, reader);
  const bool isRead = reader.ReadUpToTag(DicomTags::PixelData, { DicomTags::PixelData });
  const gdcm::TransferSyntax& syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
  const bool isDeflated = syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian;
  if (!isDeflated)
  {
    stream.ThrowIfCutShort();
  }
  if (!isRead)
  {
    throw VolumeReadingError("it is no DICOM file or is damaged");
  }
  const DicomImage image = ReadImage(DicomDataSet(reader.GetFile().GetDataSet()), stream.GetSize());
  if (!syntax.IsEncapsulated() && !isDeflated)
  {
    stream.ReadPixelElement(syntax);
  }
  return image;
}

}
