#include "MetaImageHeader.h"

#include "HeaderText.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"

#include <algorithm>

namespace penumbra
{

std::optional<std::string> MetaImageHeader::Value(const std::vector<std::string>& names) const
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

std::string MetaImageHeader::Needed(const std::string& name) const
{
  const auto value = this->Value({ name });
  if (!value)
  {
    throw VolumeReadingError("its header lacks " + name);
  }
  return *value;
}

bool MetaImageHeader::IsTrue(const std::vector<std::string>& names) const
{
  const std::string value = this->Value(names).value_or("");
  return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
}

std::vector<double> MetaImageHeader::Numbers(
  const std::vector<std::string>& names, const std::vector<double>& otherwise) const
{
  const auto value = this->Value(names);
  return value ? ToNumbers(*value, otherwise.size(), names.front()) : otherwise;
}

bool MetaImageHeader::IsLocal() const
{
  const std::string value = this->Needed("ElementDataFile");
  return value == "LOCAL" || value == "Local" || value == "local";
}

namespace
{

void ReadListedFiles(HeaderLines& lines, MetaImageHeader& header)
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

}

MetaImageHeader ReadMetaImageHeader(const std::filesystem::path& path)
{
  MetaImageHeader header;
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
    header.lines.push_back(line);
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

VolumeGeometry MetaImageGeometry(const MetaImageHeader& header)
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

}
