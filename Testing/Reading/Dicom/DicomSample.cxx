#include "DicomSample.h"

#include "DicomEncoding.h"
#include "gdcmImage.h"
#include "gdcmImageChangeTransferSyntax.h"
#include "gdcmWriter.h"

#include <cstdint>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace
{

gdcm::VR::VRType TypeOf(const DicomSample& sample, const std::string& keyword)
{
  const auto given = sample.types.find(keyword);
  if (given != sample.types.end())
  {
    return given->second;
  }
  const auto type = FindElement(keyword).type;
  return type == gdcm::VR::US_SS ? (sample.isSigned ? gdcm::VR::SS : gdcm::VR::US) : type;
}

void Put(gdcm::DataSet& dataSet, const DicomSample& sample, const DicomElements& elements)
{
  for (const auto& [keyword, text] : elements)
  {
    const auto type = TypeOf(sample, keyword);
    dataSet.Replace(Element(FindElement(keyword).tag, type, Value(text, type)));
  }
}

void PutSequences(gdcm::DataSet& dataSet, const DicomSample& sample, const DicomGroups& sequences)
{
  for (const auto& [keyword, elements] : sequences)
  {
    gdcm::DataSet item;
    Put(item, sample, elements);
    dataSet.Replace(Sequence(keyword, { item }));
  }
}

gdcm::DataSet Groups(const DicomSample& sample, const DicomGroups& groups)
{
  gdcm::DataSet dataSet;
  PutSequences(dataSet, sample, groups);
  return dataSet;
}

DicomElements Layout(const DicomSample& sample)
{
  DicomElements elements{ { "Rows", std::to_string(sample.rows) },
    { "Columns", std::to_string(sample.columns) },
    { "SamplesPerPixel", std::to_string(sample.samplesPerPixel) },
    { "PhotometricInterpretation", "MONOCHROME2" },
    { "BitsAllocated", std::to_string(sample.bitsAllocated) },
    { "BitsStored", std::to_string(sample.bitsStored) },
    { "HighBit", std::to_string(sample.highBit) },
    { "PixelRepresentation", sample.isSigned ? "1" : "0" } };
  if (sample.frames > 1)
  {
    elements["NumberOfFrames"] = std::to_string(sample.frames);
  }
  if (sample.samplesPerPixel > 1)
  {
    elements["PlanarConfiguration"] = "0";
  }
  return elements;
}

std::uint64_t Cell(const DicomSample& sample, long long value)
{
  const std::uint64_t allocated = (std::uint64_t(1) << sample.bitsAllocated) - 1;
  const int shift = sample.highBit + 1 - sample.bitsStored;
  const std::uint64_t mask = ((std::uint64_t(1) << sample.bitsStored) - 1) << shift;
  return ((static_cast<std::uint64_t>(value) << shift) & mask) |
    (sample.unusedBits ? allocated & ~mask : 0);
}

std::vector<std::uint64_t> Cells(const DicomSample& sample)
{
  std::vector<std::uint64_t> cells;
  for (int k = 0; k < sample.frames; ++k)
  {
    for (int j = 0; j < sample.rows; ++j)
    {
      for (int i = 0; i < sample.columns; ++i)
      {
        cells.insert(cells.end(), sample.samplesPerPixel, Cell(sample, sample.stored(i, j, k)));
      }
    }
  }
  return cells;
}

std::string PixelBytes(const DicomSample& sample)
{
  const auto cells = Cells(sample);
  std::string bytes((cells.size() * sample.bitsAllocated + 7) / 8, '\0');
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    for (int bit = 0; bit < sample.bitsAllocated; ++bit)
    {
      const std::size_t place = cell * sample.bitsAllocated + bit;
      bytes[place / 8] |= static_cast<char>((cells[cell] >> bit & 1) << place % 8);
    }
  }
  return bytes.size() % 2 == 0 ? bytes : bytes + '\0';
}

gdcm::DataElement Encapsulated(const DicomSample& sample, const gdcm::DataElement& pixels)
{
  gdcm::SmartPointer<gdcm::Image> image = new gdcm::Image;
  image->SetNumberOfDimensions(sample.frames > 1 ? 3 : 2);
  image->SetDimension(0, sample.columns);
  image->SetDimension(1, sample.rows);
  if (sample.frames > 1)
  {
    image->SetDimension(2, sample.frames);
  }
  image->SetPixelFormat(gdcm::PixelFormat(sample.samplesPerPixel, sample.bitsAllocated,
    sample.bitsStored, sample.highBit, sample.isSigned));
  image->SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image->SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  image->SetDataElement(pixels);
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(sample.transferSyntax);
  change.SetInput(*image);
  if (!change.Change())
  {
    throw std::invalid_argument("such pixels cannot be compressed so");
  }
  return change.GetOutput().GetDataElement();
}

gdcm::DataElement Pixels(const DicomSample& sample)
{
  const auto type = sample.bitsAllocated <= 8 ? gdcm::VR::OB : gdcm::VR::OW;
  const auto pixels = Element(gdcm::Tag(0x7fe0, 0x0010), type, PixelBytes(sample));
  return gdcm::TransferSyntax(sample.transferSyntax).IsEncapsulated() ? Encapsulated(sample, pixels)
                                                                      : pixels;
}

gdcm::DataSet Content(const DicomSample& sample)
{
  gdcm::DataSet dataSet;
  if (sample.hasPixels)
  {
    Put(dataSet, sample, Layout(sample));
    dataSet.Replace(Pixels(sample));
  }
  Put(dataSet, sample, sample.elements);
  PutSequences(dataSet, sample, sample.sequences);
  if (!sample.sharedGroups.empty())
  {
    dataSet.Replace(
      Sequence("SharedFunctionalGroupsSequence", { Groups(sample, sample.sharedGroups) }));
  }
  if (!sample.frameGroups.empty())
  {
    std::vector<gdcm::DataSet> items;
    for (const auto& groups : sample.frameGroups)
    {
      items.push_back(Groups(sample, groups));
    }
    dataSet.Replace(Sequence("PerFrameFunctionalGroupsSequence", items));
  }
  return dataSet;
}

}

std::string DicomSample::File() const
{
  std::ostringstream stream;
  gdcm::Writer writer;
  writer.GetFile().SetDataSet(Content(*this));
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(this->transferSyntax);
  writer.SetStream(stream);
  if (!writer.Write())
  {
    throw std::invalid_argument("such an image cannot be written");
  }
  return stream.str();
}

std::string WithoutPreamble(const std::string& file)
{
  return file.substr(132);
}

std::string WithoutMetaHeader(const std::string& file)
{
  // The header begins with its own length, as the 4 bytes after the first 8.
  const auto byte = [&](int i) { return static_cast<unsigned char>(file[140 + i]); };
  return file.substr(144 + byte(0) + 256 * byte(1));
}

std::string Text(const std::vector<double>& numbers)
{
  std::string text;
  for (const double number : numbers)
  {
    char part[32];
    std::snprintf(part, sizeof(part), "%.10g", number);
    text += (text.empty() ? "" : "\\") + std::string(part);
  }
  return text;
}

std::vector<double> Numbers(const std::string& text)
{
  std::vector<double> numbers;
  for (const auto& part : Parts(text))
  {
    numbers.push_back(std::stod(part));
  }
  return numbers;
}
