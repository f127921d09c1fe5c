#include "SceneNames.h"
#include "SceneSections.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
constexpr NumberRange ConeAngles{ 0.0, 180.0 };
// vtkLight takes no larger one.
constexpr NumberRange Exponents{ 0.0, 128.0 };

bool UsesDirection(LightType type)
{
  return type == LightType::Directional || type == LightType::Spot;
}
}

//------------------------------------------------------------------------------
LightDescription ParseLight(const nlohmann::json& value, const std::string& path)
{
  LightDescription light;
  JsonObject object(value, path);
  object.ReadChoice("type", light.Type, NamesOf(light.Type));
  object.Read("name", light.Name);
  object.Read("on", light.On);
  object.ReadChoice("frame", light.Frame, NamesOf(light.Frame));
  object.Read("position", light.Position, AnyNumber);
  object.Read("direction", light.Direction, AnyNumber);
  if (UsesDirection(light.Type) && Length(light.Direction) == 0.0)
  {
    RefuseValue(object.PathOf("direction"), *object.Find("direction"), "a vector other than zero");
  }
  object.Read("ambient", light.Ambient, ZeroOrMore);
  object.Read("diffuse", light.Diffuse, ZeroOrMore);
  object.Read("specular", light.Specular, ZeroOrMore);
  object.Read("intensity", light.Intensity, ZeroOrMore);
  object.Read("attenuation", light.Attenuation, AnyNumber);
  const bool isSpot = light.Type == LightType::Spot;
  object.Read("coneAngle", light.ConeAngle, isSpot ? ConeAngles : AnyNumber);
  object.Read("exponent", light.Exponent, isSpot ? Exponents : AnyNumber);
  object.ReadChoice("shadow", light.Shadow, NamesOf(light.Shadow));
  object.Read("opacityThreshold", light.OpacityThreshold, ZeroToOne);
  object.Read("shadowBias", light.ShadowBias, ZeroOrMore);
  object.RefuseUnknownKeys();
  return light;
}

}
