#include "SceneNames.h"
#include "SceneSections.h"

#include "InputError.h"
#include "Preset.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace penumbra
{
namespace
{
constexpr std::size_t FacesOfCube = 6;

// A key that the model does not use is ignored, but for its type.
NumberRange RangeIf(bool used, const NumberRange& range)
{
  return used ? range : AnyNumber;
}

void ReadModel(JsonObject& object, MaterialDescription& material)
{
  object.ReadChoice("model", material.Model, NamesOf(material.Model));
}

void ReadRoughness(JsonObject& object, MaterialDescription& material)
{
  const bool ward = material.Model == ReflectionModel::Ward;
  const bool orenNayar = material.Model == ReflectionModel::OrenNayar;
  const bool anisotropic = material.Model == ReflectionModel::WardAnisotropic;
  object.Read(
    "roughness", material.Roughness, ward ? MoreThanZero : RangeIf(orenNayar, ZeroOrMore));
  object.Read("roughnessX", material.RoughnessX, RangeIf(anisotropic, MoreThanZero));
  object.Read("roughnessY", material.RoughnessY, RangeIf(anisotropic, MoreThanZero));
  object.Read("preferredDirection", material.PreferredDirection, AnyNumber);
  if (anisotropic && Length(material.PreferredDirection) == 0.0)
  {
    RefuseValue(object.PathOf("preferredDirection"), *object.Find("preferredDirection"),
      "a vector other than zero");
  }
}

void ReadFacets(JsonObject& object, MaterialDescription& material)
{
  const bool used = material.Model == ReflectionModel::CookTorrance;
  object.Read("slope", material.Slope, RangeIf(used, MoreThanZero));
  object.ReadChoice("distribution", material.Distribution, NamesOf(material.Distribution));
  object.Read("gaussianConstant", material.GaussianConstant, RangeIf(used, ZeroOrMore));
  object.Read("indexOfRefraction", material.IndexOfRefraction, RangeIf(used, MoreThanZero));
}

bool IsEnvironmentMap(const nlohmann::json& value)
{
  const auto isName = [](const nlohmann::json& name) { return name.is_string() && name != ""; };
  return isName(value) ||
    (value.is_array() && value.size() == FacesOfCube &&
      std::all_of(value.begin(), value.end(), isName));
}

void ReadEnvironmentMap(
  JsonObject& object, const std::filesystem::path& folder, MaterialDescription& material)
{
  const nlohmann::json* value = object.Find("environmentMap");
  const bool used = material.Model == ReflectionModel::ReflectionMap;
  if (!value && used && material.EnvironmentMap.empty())
  {
    throw InputError(object.PathOf("environmentMap") +
      " is missing; the model reflection-map "
      "needs an equirectangular image, or six of the directions +x, -x, +y, -y, +z and -z");
  }
  if (!value)
  {
    return;
  }
  if (!IsEnvironmentMap(*value))
  {
    RefuseValue(object.PathOf("environmentMap"), *value,
      "the name of an equirectangular image, or six of the directions +x, -x, +y, -y, +z and -z");
  }
  const auto names = value->is_array() ? value->get<std::vector<std::string>>()
                                       : std::vector<std::string>{ value->get<std::string>() };
  material.EnvironmentMap.clear();
  for (const std::string& name : names)
  {
    material.EnvironmentMap.push_back((folder / std::filesystem::u8path(name)).lexically_normal());
  }
}
}

//------------------------------------------------------------------------------
MaterialDescription ParseMaterial(const nlohmann::json& value, const std::filesystem::path& folder)
{
  MaterialDescription material;
  JsonObject object(value, "material");
  if (object.Find("preset"))
  {
    std::string name;
    object.Read("preset", name);
    material = ParseMaterial(FindMaterial(name, object.PathOf("preset")), folder);
  }
  ReadModel(object, material);
  object.Read("ambient", material.Ambient, ZeroToOne);
  object.Read("diffuse", material.Diffuse, ZeroToOne);
  object.Read("specular", material.Specular, ZeroToOne);
  object.Read("specularPower", material.SpecularPower, ZeroOrMore);
  ReadRoughness(object, material);
  ReadFacets(object, material);
  ReadEnvironmentMap(object, folder, material);
  object.Read("noiseFading", material.NoiseFading, ZeroOrMore);
  object.RefuseUnknownKeys();
  return material;
}

}
