#include "XmlHeader.h"

#include "FileBytes.h"
#include "HeaderText.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"
#include "XmlVoxelChecks.h"
#include "vtkType.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

namespace penumbra
{

namespace
{

using Element = vtkXMLDataElement;

std::optional<std::string> Attribute(Element* element, const char* name)
{
  const char* const value = element->GetAttribute(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

std::string Needed(Element* element, const char* name)
{
  const auto value = Attribute(element, name);
  if (!value)
  {
    throw VolumeReadingError(
      "its element " + std::string(element->GetName()) + " lacks the attribute " + name);
  }
  return *value;
}

std::vector<Element*> Children(Element* parent, const std::string& name)
{
  std::vector<Element*> children;
  for (int i = 0; i < parent->GetNumberOfNestedElements(); ++i)
  {
    if (parent->GetNestedElement(i)->GetName() == name)
    {
      children.push_back(parent->GetNestedElement(i));
    }
  }
  return children;
}

Element* OnlyChild(Element* parent, const std::string& name)
{
  const auto children = Children(parent, name);
  if (children.size() != 1)
  {
    throw VolumeReadingError("its element " + std::string(parent->GetName()) + " has " +
      std::to_string(children.size()) + " elements " + name + "; one is needed");
  }
  return children[0];
}

// The array that PointData names as its scalars, or else its first.
Element* NamedScalars(Element* pointData, std::vector<std::string>& warnings)
{
  const auto name = Attribute(pointData, "Scalars");
  const auto arrays = Children(pointData, "DataArray");
  for (Element* array : arrays)
  {
    if (name && Attribute(array, "Name") == name)
    {
      return array;
    }
  }
  if (arrays.empty() || name)
  {
    throw VolumeReadingError("its PointData has no array" +
      (name ? " \"" + *name + "\"" : std::string()) + "; one scalar per point is needed");
  }
  warnings.push_back("its PointData names no scalars; the first array, \"" +
    Attribute(arrays[0], "Name").value_or("") + "\", is read");
  return arrays[0];
}

bool IsCompressed(Element* file)
{
  const auto name = Attribute(file, "compressor");
  if (name && *name != "vtkZLibDataCompressor" && *name != "vtkLZ4DataCompressor" &&
    *name != "vtkLZMADataCompressor")
  {
    throw VolumeReadingError("its compressor is \"" + *name +
      "\"; vtkZLibDataCompressor, vtkLZ4DataCompressor or vtkLZMADataCompressor is needed");
  }
  return name.has_value();
}

}

VolumeGeometry XmlGeometry(Element* image)
{
  const auto extent = ToIntegers(Needed(image, "WholeExtent"), 6, "WholeExtent");
  const auto origin = ToNumbers(Attribute(image, "Origin").value_or("0 0 0"), 3, "Origin");
  const auto spacing = ToNumbers(Attribute(image, "Spacing").value_or("1 1 1"), 3, "Spacing");
  const auto direction =
    ToNumbers(Attribute(image, "Direction").value_or("1 0 0 0 1 0 0 0 1"), 9, "Direction");
  VolumeGeometry geometry;
  std::copy(origin.begin(), origin.end(), geometry.origin.begin());
  std::copy(spacing.begin(), spacing.end(), geometry.spacing.begin());
  std::copy(direction.begin(), direction.end(), geometry.direction.begin());
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    const std::int64_t first = extent[2 * axis];
    const std::int64_t last = extent[2 * axis + 1];
    if (std::min(first, last) < -largest || std::max(first, last) > largest)
    {
      throw VolumeReadingError(
        "WholeExtent is \"" + Needed(image, "WholeExtent") + "\"; integers of 32 bits are needed");
    }
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

Element* XmlScalars(Element* image, std::vector<std::string>& warnings)
{
  Element* const file = image->GetParent();
  if (file == nullptr || std::string(file->GetName()) != "VTKFile" ||
    Attribute(file, "type").value_or("") != "ImageData")
  {
    throw VolumeReadingError("it is not a VTKFile of type ImageData");
  }
  OnlyChild(file, "ImageData");
  Element* const piece = OnlyChild(image, "Piece");
  if (ToIntegers(Needed(image, "WholeExtent"), 6, "WholeExtent") !=
    ToIntegers(Needed(piece, "Extent"), 6, "Extent"))
  {
    throw VolumeReadingError("its piece has another extent than the whole");
  }
  return NamedScalars(OnlyChild(piece, "PointData"), warnings);
}

int XmlScalarType(Element* array)
{
  const std::string components = Attribute(array, "NumberOfComponents").value_or("1");
  if (ToInteger(components, "NumberOfComponents") != 1)
  {
    throw VolumeReadingError("it has " + components + " values per voxel; one is needed");
  }
  static const std::map<std::string, int> types = { { "Int8", VTK_SIGNED_CHAR },
    { "UInt8", VTK_UNSIGNED_CHAR }, { "Int16", VTK_SHORT }, { "UInt16", VTK_UNSIGNED_SHORT },
    { "Int32", VTK_INT }, { "UInt32", VTK_UNSIGNED_INT }, { "Int64", VTK_LONG_LONG },
    { "UInt64", VTK_UNSIGNED_LONG_LONG }, { "Float32", VTK_FLOAT }, { "Float64", VTK_DOUBLE } };
  const auto type = types.find(Needed(array, "type"));
  if (type == types.end())
  {
    throw VolumeReadingError("its scalars are of type \"" + Needed(array, "type") +
      "\"; Int8 to Int64, UInt8 to UInt64, Float32 or Float64 is needed");
  }
  return type->second;
}

XmlVoxels WhereVoxelsAre(
  const std::filesystem::path& path, Element* array, vtkXMLDataParser* parser)
{
  Element* const file = parser->GetRootElement();
  const std::uint64_t fileSize = SizeOfFile(path);
  XmlVoxels voxels;
  voxels.file = path;
  voxels.bigEndian = Attribute(file, "byte_order").value_or("LittleEndian") == "BigEndian";
  voxels.headerSize = Attribute(file, "header_type").value_or("UInt32") == "UInt64" ? 8 : 4;
  voxels.isCompressed = IsCompressed(file);
  const std::string format = Attribute(array, "format").value_or("ascii");
  voxels.isText = format == "ascii";
  voxels.isBase64 = format == "binary";
  if (format == "appended")
  {
    Element* const appended = OnlyChild(file, "AppendedData");
    voxels.isBase64 = Attribute(appended, "encoding").value_or("base64") == "base64";
    const std::int64_t offset = ToInteger(Needed(array, "offset"), "offset");
    voxels.begin = static_cast<std::uint64_t>(parser->GetAppendedDataPosition());
    voxels.end = fileSize;
    if (offset < 0 || voxels.begin > voxels.end ||
      static_cast<std::uint64_t>(offset) >= voxels.end - voxels.begin)
    {
      throw VolumeReadingError(
        "its voxels have the offset " + std::to_string(offset) + ", which is not within the file");
    }
    voxels.begin += static_cast<std::uint64_t>(offset);
    return voxels;
  }
  if (!voxels.isText && !voxels.isBase64)
  {
    throw VolumeReadingError(
      "the format of its voxels is \"" + format + "\"; ascii, binary or appended is needed");
  }
  voxels.begin = PositionOf('>', path, static_cast<std::uint64_t>(array->GetXMLByteIndex())) + 1;
  voxels.end = PositionOf('<', path, voxels.begin);
  while (voxels.begin < voxels.end && Trimmed(ReadBytes(path, voxels.begin, 1)).empty())
  {
    ++voxels.begin;
  }
  return voxels;
}

}
