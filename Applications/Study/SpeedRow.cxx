#include "SpeedRow.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
using Json = nlohmann::json;

template <class T>
Json OrNull(const std::optional<T>& value)
{
  return value ? Json(*value) : Json();
}

template <class T>
std::optional<T> ReadOptional(const Json& json)
{
  return json.is_null() ? std::nullopt : std::optional<T>(json.get<T>());
}
}

//------------------------------------------------------------------------------
void to_json(Json& json, const SpeedRow& row)
{
  json = { { "scene", row.Scene }, { "hasBounds", row.HasBounds }, { "isOwnSize", row.IsOwnSize },
    { "edge", row.Edge }, { "voxels", row.Voxels }, { "image", row.Image },
    { "lights", row.Lights }, { "variant", row.Variant }, { "technique", row.Technique },
    { "resolution", row.Resolution }, { "cpuSeconds", row.CpuSeconds }, { "seconds", row.Seconds },
    { "relative", row.Relative }, { "firstCpuSeconds", row.First },
    { "lightEditCpuSeconds", OrNull(row.LightEdit) },
    { "opacityEditCpuSeconds", OrNull(row.OpacityEdit) }, { "error", OrNull(row.Error) },
    { "changedBySkipping", OrNull(row.ChangedBySkipping) },
    { "peakMemoryBytes", OrNull(row.PeakMemory) }, { "counts", row.Counts } };
}

//------------------------------------------------------------------------------
void from_json(const Json& json, SpeedRow& row)
{
  row.Scene = json.at("scene");
  row.HasBounds = json.at("hasBounds");
  row.IsOwnSize = json.at("isOwnSize");
  row.Edge = json.at("edge");
  row.Voxels = json.at("voxels");
  row.Image = json.at("image");
  row.Lights = json.at("lights");
  row.Variant = json.at("variant");
  row.Technique = json.at("technique");
  row.Resolution = json.at("resolution");
  row.CpuSeconds = json.at("cpuSeconds");
  row.Seconds = json.at("seconds");
  row.Relative = json.at("relative");
  row.First = json.at("firstCpuSeconds");
  row.LightEdit = ReadOptional<double>(json.at("lightEditCpuSeconds"));
  row.OpacityEdit = ReadOptional<double>(json.at("opacityEditCpuSeconds"));
  row.Error = ReadOptional<PictureError>(json.at("error"));
  row.ChangedBySkipping = ReadOptional<double>(json.at("changedBySkipping"));
  row.PeakMemory = ReadOptional<std::uint64_t>(json.at("peakMemoryBytes"));
  row.Counts = json.at("counts").get<std::map<std::string, double>>();
}

}
