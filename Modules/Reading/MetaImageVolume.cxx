#include "FormatReaders.h"
#include "HeaderText.h"
#include "SplitFiles.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkImageData.h"

#include <algorithm>
#include <map>

namespace penumbra
{

namespace
{

struct Header
{
  std::map<std::string, std::string> fields;
  /// What follows ElementDataFile: where that is LIST, the names of the files.
  std::vector<std::string> listedFiles;
  /// Bytes up to the end of the line ElementDataFile.
  std::uint64_t size = 0;
  std::size_t numberOfAxes = 0;

  /// The value of the first of these names that the header has.
  std::optional<std::string> Value(const std::vector<std::string>& names) const
  {
    for (const std::string& name : names)
    {
      const auto field = this->fields.find(name);
      if (field != this->fields.end())
      {
        return field->second;
      }
    }
    return std::nullopt;
  }

  std::string Needed(const std::string& name) const
  {
    const auto value = this->Value({ name });
    if (!value)
    {
      throw VolumeReadingError("its header lacks " + name);
    }
    return *value;
  }

  bool IsTrue(const std::vector<std::string>& names) const
  {
    const std::string value = this->Value(names).value_or("");
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }

  std::vector<double> Numbers(
    const std::vector<std::string>& names, const std::vector<double>& otherwise) const
  {
    const auto value = this->Value(names);
    return value ? ToNumbers(*value, otherwise.size(), names.front()) : otherwise;
  }
};

void ReadListedFiles(HeaderLines& lines, Header& header)
{
  std::string line;
  while (lines.Next(line))
  {
    if (!Trimmed(line).empty())
    {
      header.listedFiles.push_back(Trimmed(line));
    }
  }
}

Header ReadHeader(const std::filesystem::path& path)
{
  Header header;
  HeaderLines lines(path);
  std::string line;
  // ElementDataFile is the last field: voxels may follow it in the same file.
  while (header.fields.count("ElementDataFile") == 0)
  {
    if (!lines.Next(line))
    {
      throw VolumeReadingError("its header ends without ElementDataFile; the file is cut short or "
                               "not a MetaImage");
    }
    const std::size_t separator = line.find_first_of("=:");
    if (separator != std::string::npos)
    {
      header.fields[Trimmed(line.substr(0, separator))] = Trimmed(line.substr(separator + 1));
    }
  }
  header.size = lines.Position();
  if (header.fields["ElementDataFile"].compare(0, 4, "LIST") == 0)
  {
    ReadListedFiles(lines, header);
  }
  const std::int64_t axes = ToInteger(header.Needed("NDims"), "NDims");
  if (axes != 2 && axes != 3)
  {
    throw VolumeReadingError("NDims is " + std::to_string(axes) + "; 2 or 3 is needed");
  }
  header.numberOfAxes = static_cast<std::size_t>(axes);
  return header;
}

VolumeGeometry GeometryOf(const Header& header)
{
  const std::size_t axes = header.numberOfAxes;
  VolumeGeometry geometry;
  const auto sizes = ToIntegers(header.Needed("DimSize"), axes, "DimSize");
  std::copy(sizes.begin(), sizes.end(), geometry.dimensions.begin());

  const auto spacing =
    header.Numbers({ "ElementSpacing", "ElementSize" }, std::vector<double>(axes, 1.0));
  const auto origin =
    header.Numbers({ "Offset", "Position", "Origin" }, std::vector<double>(axes, 0.0));
  std::copy(spacing.begin(), spacing.end(), geometry.spacing.begin());
  std::copy(origin.begin(), origin.end(), geometry.origin.begin());
  CheckGeometry(geometry);

  std::vector<double> identity(axes * axes, 0.0);
  for (std::size_t axis = 0; axis < axes; ++axis)
  {
    identity[axis * axes + axis] = 1.0;
  }
  const auto directions =
    header.Numbers({ "TransformMatrix", "Rotation", "Orientation" }, identity);
  std::array<Vector3, 3> steps{ { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 1 } } };
  for (std::size_t axis = 0; axis < axes; ++axis)
  {
    for (std::size_t i = 0; i < axes; ++i)
    {
      steps[axis][i] = geometry.spacing[axis] * directions[axis * axes + i];
    }
  }
  SetSteps(geometry, steps);
  return geometry;
}

int ScalarTypeOf(const Header& header)
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

std::vector<std::filesystem::path> FilesOf(const std::filesystem::path& path, const Header& header)
{
  const std::string value = header.Needed("ElementDataFile");
  const std::vector<std::string> words = Words(value);
  if (words.empty())
  {
    throw VolumeReadingError("ElementDataFile is empty; LOCAL or the name of a file is needed");
  }
  if (LowerCase(value) == "local")
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

void SetOffset(const Header& header, VoxelData& data)
{
  const std::int64_t headerSize =
    ToInteger(header.Value({ "HeaderSize" }).value_or("0"), "HeaderSize");
  const bool isLocal = LowerCase(header.Needed("ElementDataFile")) == "local";
  if (isLocal)
  {
    data.offset = header.size;
  }
  else if (headerSize >= 0)
  {
    data.offset = static_cast<std::uint64_t>(headerSize);
  }
  else if (headerSize == -1 && data.encoding == VoxelEncoding::Raw)
  {
    data.offset = std::nullopt;
  }
  else
  {
    throw VolumeReadingError("HeaderSize is " + std::to_string(headerSize) +
      "; 0 or more is needed, or -1 where the data is neither compressed nor text");
  }
}

void AddWarnings(const Header& header, Warnings& warnings)
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
  const Header header = ReadHeader(path);
  const VolumeGeometry geometry = GeometryOf(header);
  VoxelData data;
  data.scalarType = ScalarTypeOf(header);
  data.files = FilesOf(path, header);
  data.bigEndian = header.IsTrue({ "BinaryDataByteOrderMSB", "ElementByteOrderMSB" });
  if (header.Value({ "BinaryData" }) && !header.IsTrue({ "BinaryData" }))
  {
    data.encoding = VoxelEncoding::Text;
  }
  else if (header.IsTrue({ "CompressedData" }))
  {
    data.encoding = VoxelEncoding::Compressed;
  }
  SetOffset(header, data);
  AddWarnings(header, warnings);
  return ReadVoxels(geometry, data, warnings);
}

}
