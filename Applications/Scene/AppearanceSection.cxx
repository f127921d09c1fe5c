#include "SceneSections.h"

#include "InputError.h"
#include "Preset.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace penumbra
{
namespace
{
template <std::size_t NumberOfValues>
bool IsPoint(const nlohmann::json& point)
{
  if (!point.is_array() || point.size() != 1 + NumberOfValues)
  {
    return false;
  }
  for (std::size_t i = 0; i < point.size(); ++i)
  {
    const NumberRange range = i == 0 ? AnyNumber : ZeroToOne;
    if (!point[i].is_number() || !range.Contains(point[i].get<double>()))
    {
      return false;
    }
  }
  return true;
}

// Points may come in any order; those at one x keep theirs, which makes a step.
template <std::size_t NumberOfValues>
void ReadPoints(
  JsonObject& object, const std::string& key, std::optional<FunctionPoints<NumberOfValues>>& target)
{
  const nlohmann::json* value = object.Find(key);
  if (!value)
  {
    return;
  }
  if (!value->is_array() || value->empty() ||
    !std::all_of(value->begin(), value->end(), IsPoint<NumberOfValues>))
  {
    RefuseValue(object.PathOf(key), *value,
      "one or more points [x, " + std::string(NumberOfValues == 1 ? "value" : "red, green, blue") +
        "] with values from 0 to 1");
  }
  target.emplace();
  for (const nlohmann::json& point : *value)
  {
    target->push_back(point.get<std::array<double, 1 + NumberOfValues>>());
  }
  std::stable_sort(target->begin(), target->end(),
    [](const auto& left, const auto& right) { return left[0] < right[0]; });
}
}

//------------------------------------------------------------------------------
TransferFunctionDescription ParseTransferFunction(
  const nlohmann::json& value, const std::filesystem::path& folder)
{
  TransferFunctionDescription function;
  JsonObject object(value, "transferFunction");
  if (object.Find("preset"))
  {
    std::string name;
    object.Read("preset", name);
    function.FromPreset = std::make_shared<const Preset>(FindPreset(name, folder));
  }
  ReadPoints<1>(object, "opacity", function.Opacity);
  ReadPoints<3>(object, "color", function.Color);
  ReadPoints<1>(object, "gradientOpacity", function.GradientOpacity);
  object.Read("opacityUnitDistance", function.OpacityUnitDistance, MoreThanZero);
  object.RefuseUnknownKeys();
  return function;
}

}
