#include "HeaderText.h"
#include "NrrdHeader.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{

namespace
{

using Vectors = std::vector<std::optional<std::vector<double>>>;

// "(1,0,0) (0,1,0) none": a vector for each axis of space, none for others.
Vectors ParseVectors(const std::string& text)
{
  Vectors vectors;
  std::size_t position = 0;
  while ((position = text.find_first_not_of(" \t", position)) != std::string::npos)
  {
    if (text.compare(position, 4, "none") == 0)
    {
      vectors.emplace_back();
      position += 4;
      continue;
    }
    const std::size_t end = text.find(')', position);
    if (text[position] != '(' || end == std::string::npos)
    {
      throw VolumeReadingError("\"" + text + "\" is not a list of vectors as \"(1,0,0) (0,1,0)\"");
    }
    std::string numbers = text.substr(position + 1, end - position - 1);
    std::replace(numbers.begin(), numbers.end(), ',', ' ');
    vectors.emplace_back(ToNumbers(numbers, Words(numbers).size(), "a vector"));
    position = end + 1;
  }
  return vectors;
}

Vector3 InThreeDimensions(const std::vector<double>& vector)
{
  if (vector.size() != 2 && vector.size() != 3)
  {
    throw VolumeReadingError(
      "its space has " + std::to_string(vector.size()) + " dimensions; 2 or 3 are needed");
  }
  return { vector[0], vector[1], vector.size() == 3 ? vector[2] : 0.0 };
}

Vectors Directions(const NrrdHeader& header)
{
  const auto text = header.Value("spacedirections");
  if (!text)
  {
    return {};
  }
  Vectors directions = ParseVectors(*text);
  if (directions.size() != header.NumberOfAxes())
  {
    throw VolumeReadingError("the field \"space directions\" is \"" + *text +
      "\"; a vector or \"none\" for each of " + std::to_string(header.NumberOfAxes()) +
      " axes is needed");
  }
  return directions;
}

bool IsSpatial(const std::string& kind)
{
  const std::string lower = LowerCase(kind);
  return lower == "domain" || lower == "space" || lower == "none" || lower == "???";
}

// The two or three axes along which voxels lie. Others must have a single value.
std::vector<std::size_t> SpatialAxes(
  const NrrdHeader& header, const std::vector<std::int64_t>& sizes, const Vectors& directions)
{
  const auto kinds = header.WordsPerAxis("kinds");
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
  {
    const bool hasDirection = directions.empty() || directions[axis].has_value();
    if (hasDirection && (!kinds || IsSpatial((*kinds)[axis])))
    {
      axes.push_back(axis);
    }
    else if (sizes[axis] != 1)
    {
      throw VolumeReadingError("its axis " + std::to_string(axis + 1) + " holds " +
        std::to_string(sizes[axis]) + " values per voxel" +
        (kinds ? " of kind " + (*kinds)[axis] : std::string()) + "; one is needed");
    }
  }
  while (axes.size() > 3 && sizes[axes.back()] == 1)
  {
    axes.pop_back();
  }
  if (axes.size() != 2 && axes.size() != 3)
  {
    throw VolumeReadingError(
      "it has " + std::to_string(axes.size()) + " axes in space; 2 or 3 are needed");
  }
  return axes;
}

/// Along one axis, where the header gives no vectors.
struct AxisScale
{
  double spacing = 1.0;
  double first = 0.0;
};

std::optional<double> ValueOf(const NrrdHeader& header, const std::string& name, std::size_t axis)
{
  const auto words = header.WordsPerAxis(name);
  return words ? std::optional<double>(ToNumber((*words)[axis], name)) : std::nullopt;
}

// Of the ends of an axis, NaN says that they are not known.
std::optional<double> EndOf(const NrrdHeader& header, const std::string& name, std::size_t axis)
{
  const auto value = ValueOf(header, name, axis);
  return value && std::isnan(*value) ? std::nullopt : value;
}

AxisScale ScaleOf(const NrrdHeader& header, std::size_t axis, std::int64_t size)
{
  const auto centers = header.WordsPerAxis(header.Value("centers") ? "centers" : "centerings");
  const bool isCell = centers && LowerCase((*centers)[axis]) == "cell";
  const auto spacing = ValueOf(header, "spacings", axis);
  const auto low = EndOf(header, "axismins", axis);
  const auto high = EndOf(header, "axismaxs", axis);
  AxisScale scale;
  if (spacing)
  {
    scale.spacing = *spacing;
  }
  else if (low && high && (isCell || size > 1))
  {
    scale.spacing = (*high - *low) / static_cast<double>(isCell ? size : size - 1);
  }
  scale.first = low.value_or(0.0) + (low && isCell ? 0.5 * scale.spacing : 0.0);
  return scale;
}

void PlaceByScales(const NrrdHeader& header, const std::vector<std::size_t>& axes,
  const std::vector<std::int64_t>& sizes, VolumeGeometry& geometry)
{
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    const AxisScale scale = ScaleOf(header, axes[i], sizes[axes[i]]);
    geometry.spacing[i] = scale.spacing;
    geometry.origin[i] = scale.first;
  }
}

void PlaceByDirections(
  const std::vector<std::size_t>& axes, const Vectors& directions, VolumeGeometry& geometry)
{
  std::array<Vector3, 3> steps;
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    steps[i] = InThreeDimensions(*directions[axes[i]]);
  }
  if (axes.size() == 2)
  {
    vtkMath::Cross(steps[0].data(), steps[1].data(), steps[2].data());
    vtkMath::Normalize(steps[2].data());
  }
  SetSteps(geometry, steps);
}

}

VolumeGeometry NrrdGeometry(const NrrdHeader& header)
{
  const auto sizes =
    ToIntegers(header.Needed("sizes"), header.NumberOfAxes(), "the field \"sizes\"");
  const Vectors directions = Directions(header);
  const std::vector<std::size_t> axes = SpatialAxes(header, sizes, directions);
  VolumeGeometry geometry;
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    geometry.dimensions[i] = sizes[axes[i]];
  }
  if (directions.empty())
  {
    PlaceByScales(header, axes, sizes, geometry);
  }
  else
  {
    PlaceByDirections(axes, directions, geometry);
  }
  if (const auto origin = header.Value("spaceorigin"))
  {
    const Vectors vectors = ParseVectors(*origin);
    if (vectors.size() != 1 || !vectors[0])
    {
      throw VolumeReadingError(
        "the field \"space origin\" is \"" + *origin + "\"; one vector as \"(0,0,0)\" is needed");
    }
    geometry.origin = InThreeDimensions(*vectors[0]);
  }
  return geometry;
}

}
