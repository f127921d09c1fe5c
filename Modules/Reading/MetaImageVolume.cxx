#include "FormatReaders.h"
#include "HeaderText.h"
#include "MetaImageHeader.h"
#include "ReaderErrors.h"
#include "SplitFiles.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace penumbra
{

namespace
{

int ScalarTypeOf(const MetaImageHeader& header)
{
  // MetaImage's LONG has four bytes whatever the machine's long has.
  static const std::map<std::string, int> types = { { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR }, { "MET_SHORT", VTK_SHORT },
    { "MET_USHORT", VTK_UNSIGNED_SHORT }, { "MET_INT", VTK_INT }, { "MET_UINT", VTK_UNSIGNED_INT },
    { "MET_LONG", VTK_INT }, { "MET_ULONG", VTK_UNSIGNED_INT }, { "MET_LONG_LONG", VTK_LONG_LONG },
    { "MET_ULONG_LONG", VTK_UNSIGNED_LONG_LONG }, { "MET_FLOAT", VTK_FLOAT },
    { "MET_DOUBLE", VTK_DOUBLE } };
  const std::string name = header.Needed("ElementType");
  const auto type = types.find(name);
  if (type == types.end())
  {
    throw VolumeReadingError("ElementType is \"" + name +
      "\"; MET_CHAR, MET_SHORT, MET_INT, MET_LONG_LONG, their MET_U... forms, MET_FLOAT or "
      "MET_DOUBLE is needed");
  }
  const std::string channels = header.Value({ "ElementNumberOfChannels" }).value_or("1");
  if (ToInteger(channels, "ElementNumberOfChannels") != 1)
  {
    throw VolumeReadingError("it has " + channels + " values per voxel; one is needed");
  }
  return type->second;
}

std::vector<std::filesystem::path> FilesOf(
  const std::filesystem::path& path, const MetaImageHeader& header)
{
  const std::string value = header.Needed("ElementDataFile");
  const std::vector<std::string> words = Words(value);
  if (words.empty())
  {
    throw VolumeReadingError("ElementDataFile is empty; LOCAL or the name of a file is needed");
  }
  if (header.IsLocal())
  {
    return { path };
  }
  if (words[0] == "LIST")
  {
    return DataFiles(path, header.listedFiles);
  }
  if (value.find('%') == std::string::npos)
  {
    return DataFiles(path, { value });
  }
  const auto slices = Words(header.Needed("DimSize")).back();
  const auto number = [&words](std::size_t word, const std::string& otherwise) {
    return ToInteger(word < words.size() ? words[word] : otherwise, "a number of ElementDataFile");
  };
  return DataFiles(
    path, ExpandPattern(words[0], number(1, "1"), number(2, slices), number(3, "1")));
}

void SetOffset(const MetaImageHeader& header, VoxelData& data)
{
  const std::int64_t headerSize =
    ToInteger(header.Value({ "HeaderSize" }).value_or("0"), "HeaderSize");
  if (header.IsLocal())
  {
    data.offset = header.size;
  }
  else if (headerSize == -1 && !data.compression)
  {
    data.offset = std::nullopt;
  }
  else if (headerSize < 0)
  {
    throw VolumeReadingError("HeaderSize is " + std::to_string(headerSize) +
      "; 0 or more is needed, or -1 where the data is not compressed");
  }
  else
  {
    data.offset = static_cast<std::uint64_t>(headerSize);
  }
}

bool IsForMetaIO(const std::string& line)
{
  constexpr std::size_t longest = 250;
  const auto isControl = [](char letter)
  { return static_cast<unsigned char>(letter) < ' ' && letter != '\t'; };
  const bool isPlain = std::none_of(line.begin(), line.end(), isControl);
  return line.size() <= longest && isPlain && line.find_first_of("=:") != std::string::npos;
}

// MetaIO, which vtkMetaImageReader reads by, writes beyond its buffers where a line is too long,
// reports other lines than "Key = value" to stderr, and needs the size of the compressed data.
void CheckForMetaIO(const MetaImageHeader& header, const VoxelData& data)
{
  for (const std::string& line : header.lines)
  {
    if (!IsForMetaIO(line))
    {
      throw VolumeReadingError("where the data is compressed, a line of its header must be a key, "
                               "= and a value in at most 250 bytes, but one is \"" +
        line.substr(0, 40) + (line.size() > 40 ? "...\"" : "\""));
    }
  }
  const std::string type = header.Needed("ElementType");
  const std::string file = header.Needed("ElementDataFile");
  if (!header.listedFiles.empty() || file.find('%') != std::string::npos ||
    type.find("LONG") != std::string::npos)
  {
    throw VolumeReadingError("its data is compressed, of type " + type + " and in \"" + file +
      "\"; where compressed, one named file of a type without LONG is needed");
  }
  if (header.IsLocal() && header.Numbers({ "HeaderSize" }, { 0.0 })[0] != 0.0)
  {
    throw VolumeReadingError("HeaderSize is " + header.Needed("HeaderSize") +
      "; 0 is needed where compressed data follows the header");
  }
  const std::size_t axes = header.numberOfAxes;
  const std::pair<const char*, std::size_t> numbers[] = { { "ID", 1 }, { "ParentID", 1 },
    { "CompressionLevel", 1 }, { "ElementMin", 1 }, { "ElementMax", 1 }, { "ElementNBits", 1 },
    { "Color", 4 }, { "SequenceID", axes }, { "ElementSpacing", axes }, { "ElementSize", axes },
    { "Offset", axes }, { "Position", axes }, { "Origin", axes },
    { "TransformMatrix", axes * axes }, { "Rotation", axes * axes },
    { "Orientation", axes * axes } };
  for (const auto& [name, count] : numbers)
  {
    for (const double number : header.Numbers({ name }, std::vector<double>(count, 0.0)))
    {
      if (!std::isfinite(number))
      {
        throw VolumeReadingError(std::string(name) + " holds what is not a finite number");
      }
    }
  }
  const std::uint64_t present = SizeOfFile(data.files.front()) - *data.offset;
  const auto stated = header.Value({ "CompressedDataSize" });
  if (*data.offset > 0 && !stated)
  {
    throw VolumeReadingError(
      "its header lacks CompressedDataSize, which would be " + std::to_string(present));
  }
  if (stated && ToInteger(*stated, "CompressedDataSize") != static_cast<std::int64_t>(present))
  {
    throw VolumeReadingError("CompressedDataSize is " + *stated + ", but its compressed data has " +
      std::to_string(present) + " bytes");
  }
}

void AddWarnings(const MetaImageHeader& header, Warnings& warnings)
{
  for (const double center :
    header.Numbers({ "CenterOfRotation" }, std::vector<double>(header.numberOfAxes, 0.0)))
  {
    if (center != 0.0)
    {
      warnings.push_back("CenterOfRotation is not applied, as in ITK: Offset is where the first "
                         "voxel lies");
      break;
    }
  }
  if (header.Numbers({ "ElementToIntensityFunctionSlope" }, { 1.0 })[0] != 1.0 ||
    header.Numbers({ "ElementToIntensityFunctionOffset" }, { 0.0 })[0] != 0.0)
  {
    warnings.push_back("ElementToIntensityFunctionSlope and -Offset are not applied, as in ITK: "
                       "voxels keep the values of the file");
  }
}

}

Volume ReadMetaImageVolume(const std::filesystem::path& path, Warnings& warnings)
{
  const MetaImageHeader header = ReadMetaImageHeader(path);
  const VolumeGeometry geometry = MetaImageGeometry(header);
  VoxelData data;
  data.scalarType = ScalarTypeOf(header);
  data.files = FilesOf(path, header);
  data.bigEndian = header.IsTrue({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" });
  if (header.Value({ "BinaryData" }) && !header.IsTrue({ "BinaryData" }))
  {
    throw VolumeReadingError("its voxels are text (BinaryData is not True); binary data is needed");
  }
  if (header.IsTrue({ "CompressedData" }))
  {
    data.compression = CompressedFormat::ZlibOrGzip;
  }
  SetOffset(header, data);
  CheckVoxelData(geometry, data);
  AddWarnings(header, warnings);
  if (!data.compression)
  {
    // What vtkMetaImageReader itself is based on, and without the limits of MetaIO.
    return FinishedVolume(geometry, ReadUncompressed(geometry, data), warnings);
  }
  CheckForMetaIO(header, data);
  ReaderErrors errors;
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(path.u8string().c_str());
  return FinishedVolume(geometry, RunReader(reader, errors, geometry, data.scalarType), warnings);
}

}
