#include "FormatReaders.h"
#include "HeaderText.h"
#include "NrrdHeader.h"
#include "ReaderErrors.h"
#include "SplitFiles.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

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

std::optional<CompressedFormat> CompressionOf(const NrrdHeader& header)
{
  const std::string name = LowerCase(header.Needed("encoding"));
  if (name == "raw")
  {
    return std::nullopt;
  }
  if (name == "gzip" || name == "gz")
  {
    return CompressedFormat::Gzip;
  }
  // VTK reads text of bytes as letters, and text that follows the header not at all.
  throw VolumeReadingError("the field \"encoding\" is \"" + name + "\"; raw or gzip is needed");
}

bool IsBigEndian(const NrrdHeader& header, int scalarType)
{
  if (vtkDataArray::GetDataTypeSize(scalarType) == 1)
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

void SetOffset(const NrrdHeader& header, VoxelData& data)
{
  if (ToInteger(header.Value("lineskip").value_or("0"), "the field \"line skip\"") != 0)
  {
    throw VolumeReadingError("the field \"line skip\" is not 0, which is not read");
  }
  data.offset = header.Value("datafile") ? 0 : header.size;
  const std::int64_t skipped =
    ToInteger(header.Value("byteskip").value_or("0"), "the field \"byte skip\"");
  if (skipped < -1 || (skipped != 0 && data.compression))
  {
    throw VolumeReadingError("the field \"byte skip\" is " + std::to_string(skipped) +
      "; 0 is needed, or -1 or more where the encoding is raw");
  }
  if (skipped == -1)
  {
    data.offset = std::nullopt;
  }
  else
  {
    *data.offset += static_cast<std::uint64_t>(skipped);
  }
}

// vtkNrrdReader has zlib count in 32 bits and takes the first of several compressed files for all.
void CheckCompressedSize(const VolumeGeometry& geometry, const VoxelData& data)
{
  constexpr std::uint64_t largest = 0x7fffffff;
  const std::uint64_t scalarSize = vtkDataArray::GetDataTypeSize(data.scalarType);
  if (data.files.size() != 1 || NumberOfVoxels(geometry, scalarSize) > largest / scalarSize)
  {
    throw VolumeReadingError("its voxels are compressed in " + std::to_string(data.files.size()) +
      " files; one of less than 2 GiB of voxels is needed, or the encoding raw");
  }
}

/**
 * Reads the voxels alone: of the header vtkNrrdReader takes a first axis of up to 9 voxels for the
 * components of one, and it knows neither "byte skip" nor every spelling of fields.
 */
class NrrdVoxelReader : public vtkNrrdReader
{
public:
  static NrrdVoxelReader* New();
  vtkTypeMacro(NrrdVoxelReader, vtkNrrdReader);

  void SetUp(
    const std::filesystem::path& header, const VolumeGeometry& geometry, const VoxelData& data)
  {
    SetUpReader(this, geometry, data);
    this->SetFileName(header.u8string().c_str());
    this->Encoding = data.compression ? ENCODING_GZIP : ENCODING_RAW;
    for (const auto& file : data.files)
    {
      this->DataFiles->InsertNextValue(file.u8string());
    }
  }

protected:
  using vtkNrrdReader::ReadHeader;
  int ReadHeader() override { return 1; }
};

vtkStandardNewMacro(NrrdVoxelReader);

}

Volume ReadNrrdVolume(const std::filesystem::path& path, Warnings& warnings)
{
  const NrrdHeader header = ReadNrrdHeader(path);
  const VolumeGeometry geometry = NrrdGeometry(header);
  VoxelData data;
  data.scalarType = ScalarTypeOf(header);
  data.compression = CompressionOf(header);
  data.bigEndian = IsBigEndian(header, data.scalarType);
  data.files = FilesOf(path, header);
  SetOffset(header, data);
  CheckVoxelData(geometry, data);
  if (data.compression)
  {
    CheckCompressedSize(geometry, data);
  }
  ReaderErrors errors;
  vtkNew<NrrdVoxelReader> reader;
  reader->SetUp(path, geometry, data);
  auto voxels = RunReader(reader, errors, geometry, data.scalarType);
  CheckAllWasRead(reader);
  return FinishedVolume(geometry, voxels, warnings);
}

}
