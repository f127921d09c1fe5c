#include "ByteStream.h"
#include "FormatReaders.h"
#include "HeaderText.h"
#include "VolumeGeometry.h"
#include "VoxelArray.h"
#include "XmlDocument.h"
#include "XmlVoxels.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>

namespace penumbra
{

namespace
{

using Elements = std::vector<XmlElement>;

// The one element `name` within `parent`.
const XmlElement& OnlyChild(
  const Elements& elements, const XmlElement& parent, const std::string& name)
{
  const XmlElement* child = nullptr;
  int count = 0;
  for (const XmlElement& element : elements)
  {
    if (element.name == name && &elements[element.parent] == &parent && &element != &parent)
    {
      child = &element;
      ++count;
    }
  }
  if (count != 1)
  {
    throw VolumeReadingError("its element " + parent.name + " has " + std::to_string(count) +
      " elements " + name + "; one is needed");
  }
  return *child;
}

void CheckEnd(const std::filesystem::path& path)
{
  constexpr std::uint64_t length = 64;
  const std::uint64_t size = SizeOfFile(path);
  std::string end(length, '\0');
  end.resize(OpenBytes(path, size - std::min(size, length), false)->Read(end.data(), length));
  const std::string closingTag = "</VTKFile>";
  const std::string trimmed = Trimmed(end);
  if (trimmed.size() < closingTag.size() ||
    trimmed.compare(trimmed.size() - closingTag.size(), closingTag.size(), closingTag) != 0)
  {
    throw VolumeReadingError("it does not end with </VTKFile>; the file is cut short");
  }
}

// The geometry with the index of the first voxel moved to (0, 0, 0).
VolumeGeometry GeometryOf(const XmlElement& image)
{
  const auto extent = ToIntegers(image.Needed("WholeExtent"), 6, "WholeExtent");
  const auto origin = ToNumbers(image.Attribute("Origin").value_or("0 0 0"), 3, "Origin");
  const auto spacing = ToNumbers(image.Attribute("Spacing").value_or("1 1 1"), 3, "Spacing");
  const auto direction =
    ToNumbers(image.Attribute("Direction").value_or("1 0 0 0 1 0 0 0 1"), 9, "Direction");
  VolumeGeometry geometry;
  std::copy(origin.begin(), origin.end(), geometry.origin.begin());
  std::copy(spacing.begin(), spacing.end(), geometry.spacing.begin());
  std::copy(direction.begin(), direction.end(), geometry.direction.begin());
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    const std::int64_t first = std::clamp(extent[2 * axis], -largest, largest);
    const std::int64_t last = std::clamp(extent[2 * axis + 1], -largest, largest);
    geometry.dimensions[axis] = last - first + 1;
  }
  CheckGeometry(geometry);

  std::array<Vector3, 3> steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      steps[axis][row] = direction[3 * row + axis] * spacing[axis];
      geometry.origin[row] += steps[axis][row] * static_cast<double>(extent[2 * axis]);
    }
  }
  SetSteps(geometry, steps);
  return geometry;
}

// The array that PointData names as its scalars, or else its first.
const XmlElement& ScalarsOf(
  const Elements& elements, const XmlElement& pointData, Warnings& warnings)
{
  const auto name = pointData.Attribute("Scalars");
  const XmlElement* first = nullptr;
  for (const XmlElement& element : elements)
  {
    const bool isArray = element.name == "DataArray" && &elements[element.parent] == &pointData;
    if (isArray && name && element.Attribute("Name") == name)
    {
      return element;
    }
    first = isArray && first == nullptr ? &element : first;
  }
  if (first == nullptr || name)
  {
    throw VolumeReadingError("its PointData has no array" +
      (name ? " \"" + *name + "\"" : std::string()) + "; one scalar per point is needed");
  }
  warnings.push_back("its PointData names no scalars; the first array, \"" +
    first->Attribute("Name").value_or("") + "\", is read");
  return *first;
}

int ScalarTypeOf(const XmlElement& array)
{
  const std::string components = array.Attribute("NumberOfComponents").value_or("1");
  if (ToInteger(components, "NumberOfComponents") != 1)
  {
    throw VolumeReadingError("it has " + components + " values per voxel; one is needed");
  }
  const std::string name = LowerCase(array.Needed("type"));
  if (name == "int64" || name == "uint64")
  {
    return name == "int64" ? VTK_LONG_LONG : VTK_UNSIGNED_LONG_LONG;
  }
  const auto type = ScalarTypeFromName(name);
  if (!type)
  {
    throw VolumeReadingError("its scalars are of type \"" + array.Needed("type") +
      "\"; Int8 to Int64, UInt8 to UInt64, Float32 or Float64 is needed");
  }
  return *type;
}

// Where AppendedData begins: after the underscore that follows its start tag.
std::uint64_t BeginOfAppended(const std::filesystem::path& path, const XmlElement& appended)
{
  const auto stream = OpenPart(path, appended.contentBegin, appended.contentEnd);
  char letter = 0;
  for (std::uint64_t position = appended.contentBegin; stream->Read(&letter, 1) == 1; ++position)
  {
    if (letter == '_')
    {
      return position + 1;
    }
    if (Trimmed(std::string(1, letter)).size() > 0)
    {
      break;
    }
  }
  throw VolumeReadingError("its AppendedData does not begin with an underscore");
}

XmlVoxels VoxelsOf(
  const std::filesystem::path& path, const Elements& elements, const XmlElement& array)
{
  const XmlElement& file = elements.front();
  XmlVoxels voxels;
  voxels.file = path;
  voxels.begin = array.contentBegin;
  voxels.end = array.contentEnd;
  voxels.bigEndian = file.Attribute("byte_order").value_or("LittleEndian") == "BigEndian";
  voxels.headerSize = file.Attribute("header_type").value_or("UInt32") == "UInt64" ? 8 : 4;
  voxels.compressor = file.Attribute("compressor").value_or("");
  const std::string format = LowerCase(array.Attribute("format").value_or("ascii"));
  voxels.isText = format == "ascii";
  voxels.isBase64 = format == "binary";
  if (format == "appended")
  {
    const XmlElement& appended = OnlyChild(elements, file, "AppendedData");
    voxels.isBase64 = LowerCase(appended.Attribute("encoding").value_or("base64")) == "base64";
    const std::int64_t offset = ToInteger(array.Needed("offset"), "offset");
    voxels.begin = BeginOfAppended(path, appended);
    voxels.end = appended.contentEnd;
    if (offset < 0 || static_cast<std::uint64_t>(offset) >= voxels.end - voxels.begin)
    {
      throw VolumeReadingError(
        "its voxels have the offset " + std::to_string(offset) + ", which is not within the file");
    }
    voxels.begin += static_cast<std::uint64_t>(offset);
  }
  else if (!voxels.isText && !voxels.isBase64)
  {
    throw VolumeReadingError(
      "the format of its voxels is \"" + format + "\"; ascii, binary or appended is needed");
  }
  return voxels;
}

}

Volume ReadXmlImageVolume(const std::filesystem::path& path, Warnings& warnings)
{
  CheckEnd(path);
  const Elements elements = ReadXmlElements(path);
  const XmlElement& file = elements.front();
  if (file.name != "VTKFile" || file.Attribute("type").value_or("") != "ImageData")
  {
    throw VolumeReadingError("it is not a VTKFile of type ImageData");
  }
  const XmlElement& image = OnlyChild(elements, file, "ImageData");
  const XmlElement& piece = OnlyChild(elements, image, "Piece");
  const VolumeGeometry geometry = GeometryOf(image);
  if (ToIntegers(piece.Needed("Extent"), 6, "Extent") !=
    ToIntegers(image.Needed("WholeExtent"), 6, "WholeExtent"))
  {
    throw VolumeReadingError("its piece has another extent than the whole");
  }
  const XmlElement& array = ScalarsOf(elements, OnlyChild(elements, piece, "PointData"), warnings);
  const int scalarType = ScalarTypeOf(array);
  const XmlVoxels voxels = VoxelsOf(path, elements, array);
  const std::uint64_t count = NumberOfVoxels(geometry, vtkDataArray::GetDataTypeSize(scalarType));
  CheckSize(voxels, scalarType, count);

  auto scalars = AllocateVoxels(scalarType, count);
  ReadXmlVoxels(voxels, scalarType, count, scalars->GetVoidPointer(0));
  scalars = WithoutLongIntegers(scalars, warnings);
  scalars->SetName(array.Attribute("Name").value_or("scalars").c_str());
  auto result = Volume::New();
  ApplyGeometry(geometry, result);
  result->GetPointData()->SetScalars(scalars);
  return result;
}

}
