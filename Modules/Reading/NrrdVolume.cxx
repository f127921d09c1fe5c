#include "FormatReaders.h"
#include "HeaderText.h"
#include "NrrdHeader.h"
#include "SplitFiles.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <map>

namespace penumbra
{

namespace
{

int ScalarTypeOf(const NrrdHeader& header)
{
  static const std::map<std::string, int> types = { { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT }, { "int16", VTK_SHORT },
    { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG },
    { "signed long long", VTK_LONG_LONG }, { "signed long long int", VTK_LONG_LONG },
    { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  const std::string name = header.Needed("type");
  const auto type = types.find(LowerCase(name));
  if (type == types.end())
  {
    throw VolumeReadingError("the field \"type\" is \"" + name +
      "\"; an integer type of 8 to 64 bits, float or double is needed");
  }
  return type->second;
}

VoxelEncoding EncodingOf(const NrrdHeader& header)
{
  const std::string name = LowerCase(header.Needed("encoding"));
  if (name == "raw")
  {
    return VoxelEncoding::Raw;
  }
  if (name == "gzip" || name == "gz")
  {
    return VoxelEncoding::Compressed;
  }
  if (name == "text" || name == "txt" || name == "ascii")
  {
    return VoxelEncoding::Text;
  }
  throw VolumeReadingError(
    "the field \"encoding\" is \"" + name + "\"; raw, gzip or text is needed");
}

bool IsBigEndian(const NrrdHeader& header, const VoxelData& data)
{
  if (data.encoding == VoxelEncoding::Text || vtkDataArray::GetDataTypeSize(data.scalarType) == 1)
  {
    return false;
  }
  const std::string order = LowerCase(header.Needed("endian"));
  if (order != "little" && order != "big")
  {
    throw VolumeReadingError("the field \"endian\" is \"" + order + "\"; little or big is needed");
  }
  return order == "big";
}

std::vector<std::filesystem::path> FilesOf(
  const std::filesystem::path& path, const NrrdHeader& header)
{
  if (!header.Value("datafile"))
  {
    return { path };
  }
  const std::string value = header.Needed("datafile");
  const std::vector<std::string> words = Words(value);
  if (words[0] == "LIST")
  {
    return DataFiles(path, header.listedFiles);
  }
  if (value.find('%') == std::string::npos)
  {
    return DataFiles(path, { value });
  }
  if (words.size() != 4 && words.size() != 5)
  {
    throw VolumeReadingError("the field \"data file\" is \"" + value +
      "\"; a pattern, the first number, the last and the step are needed");
  }
  const auto number = [&words](std::size_t word)
  { return ToInteger(words[word], "a number of the field \"data file\""); };
  return DataFiles(path, ExpandPattern(words[0], number(1), number(2), number(3)));
}

// Bytes to be left out before the voxels: of the stream where it is compressed, else of the file.
void SetOffset(const NrrdHeader& header, VoxelData& data)
{
  if (ToInteger(header.Value("lineskip").value_or("0"), "the field \"line skip\"") != 0)
  {
    throw VolumeReadingError("the field \"line skip\" is not 0, which is not read");
  }
  data.offset = header.Value("datafile") ? 0 : header.size;
  const std::int64_t skipped =
    ToInteger(header.Value("byteskip").value_or("0"), "the field \"byte skip\"");
  if (skipped == -1 && data.encoding == VoxelEncoding::Raw)
  {
    data.offset = std::nullopt;
  }
  else if (skipped < 0)
  {
    throw VolumeReadingError("the field \"byte skip\" is " + std::to_string(skipped) +
      "; 0 or more is needed, or -1 where the encoding is raw");
  }
  else
  {
    (data.encoding == VoxelEncoding::Compressed ? data.offsetInStream : *data.offset) +=
      static_cast<std::uint64_t>(skipped);
  }
}

}

Volume ReadNrrdVolume(const std::filesystem::path& path, Warnings& warnings)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  const VolumeGeometry geometry = NrrdGeometry(header);
  VoxelData data;
  data.scalarType = ScalarTypeOf(header);
  data.encoding = EncodingOf(header);
  data.bigEndian = IsBigEndian(header, data);
  data.files = FilesOf(path, header);
  SetOffset(header, data);
  return ReadVoxels(geometry, data, warnings);
}

}
