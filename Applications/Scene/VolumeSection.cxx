#include "SceneSections.h"

#include "InputError.h"
#include "ScalarTypes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

namespace penumbra
{
namespace
{
// Largest header of a .raw file, and the largest whole number that a JSON reader surely keeps.
constexpr std::int64_t LargestHeader = 9007199254740992;

// Columns of a matrix whose determinant is a smaller part of their lengths' product are parallel or
// in one plane, up to rounding.
constexpr double SmallestIndependence = 1e-9;

std::string ExtensionOf(const std::filesystem::path& file)
{
  std::string extension = file.extension().u8string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

bool AreIndependent(const Vector3& x, const Vector3& y, const Vector3& z)
{
  const double product = Length(x) * Length(y) * Length(z);
  return product > 0.0 && std::abs(Dot(x, Cross(y, z))) > SmallestIndependence * product;
}

void CheckTransform(
  const JsonObject& object, const std::array<double, 16>& m, const nlohmann::json& value)
{
  if (m[12] != 0.0 || m[13] != 0.0 || m[14] != 0.0 || m[15] != 1.0)
  {
    RefuseValue(object.PathOf("transform"), value, "16 numbers whose last four are 0, 0, 0, 1");
  }
  if (!AreIndependent({ m[0], m[4], m[8] }, { m[1], m[5], m[9] }, { m[2], m[6], m[10] }))
  {
    RefuseValue(object.PathOf("transform"), value, "an invertible matrix");
  }
}

void CheckCropping(
  const JsonObject& object, const std::array<double, 6>& cropping, const nlohmann::json& value)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (cropping[2 * axis] > cropping[2 * axis + 1])
    {
      RefuseValue(object.PathOf("cropping"), value,
        "an interval for each axis, its smaller end first: x, x, y, y, z, z");
    }
  }
}

std::filesystem::path ReadFile(
  JsonObject& object, const std::string& key, const std::filesystem::path& folder)
{
  std::string name;
  object.Read(key, name);
  if (name.empty())
  {
    throw InputError(object.PathOf(key) + " is " + (object.Find(key) ? "empty" : "missing") +
      "; it names the file of a volume");
  }
  return (folder / std::filesystem::u8path(name)).lexically_normal();
}

void ReadScalarType(JsonObject& object, std::optional<int>& scalarType)
{
  std::string name;
  object.Read("scalarType", name);
  scalarType = ScalarTypeFromName(name);
  if (!scalarType)
  {
    RefuseValue(object.PathOf("scalarType"), *object.Find("scalarType"), ScalarTypeNames());
  }
}

void ReadRawGeometry(JsonObject& object, VolumeDescription& volume)
{
  for (const char* key : { "dimensions", "scalarType" })
  {
    if (!object.Find(key))
    {
      throw InputError(object.PathOf(key) + " is missing; a .raw file needs it, such as " +
        (key == std::string("dimensions") ? "[256,256,128]" : "\"uint8\""));
    }
  }
  object.Read("dimensions", volume.Dimensions, 1, std::numeric_limits<int>::max());
  ReadScalarType(object, volume.ScalarType);
  object.Read("spacing", volume.Spacing, MoreThanZero);
  object.Read("origin", volume.Origin, AnyNumber);
  object.Read("direction", volume.Direction, AnyNumber);
  object.ReadChoice<bool>("byteOrder", volume.BigEndian, { { "little", false }, { "big", true } });
  std::int64_t headerBytes = 0;
  object.Read("headerBytes", headerBytes, 0, LargestHeader);
  volume.HeaderBytes = static_cast<std::uint64_t>(headerBytes);
  const auto& d = volume.Direction;
  if (!AreIndependent({ d[0], d[3], d[6] }, { d[1], d[4], d[7] }, { d[2], d[5], d[8] }))
  {
    RefuseValue(object.PathOf("direction"), *object.Find("direction"), "an invertible matrix");
  }
}

void ReadSeries(JsonObject& object, std::optional<std::string>& series)
{
  std::string name;
  object.Read("series", name);
  if (!name.empty())
  {
    series = name;
  }
}

// Other formats know their geometry: these keys may stand there, and hold whatever is of their
// type.
void IgnoreRawGeometry(JsonObject& object)
{
  for (const char* key : { "dimensions", "spacing", "origin" })
  {
    Vector3 ignored{};
    object.Read(key, ignored, AnyNumber);
  }
  for (const char* key : { "scalarType", "byteOrder" })
  {
    std::string ignored;
    object.Read(key, ignored);
  }
  std::array<double, 9> direction{};
  object.Read("direction", direction, AnyNumber);
  double headerBytes = 0.0;
  object.Read("headerBytes", headerBytes, AnyNumber);
}
}

//------------------------------------------------------------------------------
VolumeDescription ParseVolume(const nlohmann::json& value, const std::filesystem::path& folder)
{
  VolumeDescription volume;
  JsonObject object(value, "volume");
  volume.File = ReadFile(object, "file", folder);
  if (ExtensionOf(volume.File) == ".raw")
  {
    ReadRawGeometry(object, volume);
  }
  else
  {
    IgnoreRawGeometry(object);
  }
  ReadSeries(object, volume.Series);
  object.Read("transform", volume.Transform, AnyNumber);
  if (const nlohmann::json* transform = object.Find("transform"))
  {
    CheckTransform(object, volume.Transform, *transform);
  }
  object.Read("cropping", volume.Cropping, AnyNumber);
  if (volume.Cropping)
  {
    CheckCropping(object, *volume.Cropping, *object.Find("cropping"));
  }
  if (object.Find("mask"))
  {
    volume.Mask = ReadFile(object, "mask", folder);
  }
  object.RefuseUnknownKeys();
  return volume;
}

}
