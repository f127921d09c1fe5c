#include "LightEdits.h"

#include <QObject>

#include <algorithm>

namespace penumbra
{
namespace
{
// To the right, up and towards the viewer.
constexpr Vector3 UpperLeft = { -0.55, 0.6, 0.75 };

Vector3 ToWorld(const Vector3& direction, const ViewFrame& view)
{
  return Sum(Scaled(view.Right, direction[0]),
    Sum(Scaled(view.Up, direction[1]), Scaled(view.Backward, direction[2])));
}

Vector3 ToView(const Vector3& direction, const ViewFrame& view)
{
  return { Dot(direction, view.Right), Dot(direction, view.Up), Dot(direction, view.Backward) };
}

bool HasPosition(const LightDescription& light)
{
  return light.Type == LightType::Point || light.Type == LightType::Spot;
}

Vector3 WorldPosition(const LightDescription& light, const ViewFrame& view)
{
  return light.Frame == LightFrame::Camera ? Sum(view.Position, ToWorld(light.Position, view))
                                           : light.Position;
}

void SetWorldPosition(LightDescription& light, const ViewFrame& view, const Vector3& position)
{
  light.Position = light.Frame == LightFrame::Camera
    ? ToView(Difference(position, view.Position), view)
    : position;
}

void SetWorldDirection(LightDescription& light, const ViewFrame& view, const Vector3& direction)
{
  light.Direction = light.Frame == LightFrame::Camera ? ToView(direction, view) : direction;
}

bool IsNameTaken(const SceneDescription& scene, const std::string& name)
{
  return std::any_of(scene.Lights.begin(), scene.Lights.end(),
    [&name](const LightDescription& light) { return light.Name == name; });
}

std::string FreeName(const SceneDescription& scene, const std::string& wish)
{
  std::string name = wish;
  for (int number = 2; IsNameTaken(scene, name); ++number)
  {
    name = wish + " " + std::to_string(number);
  }
  return name;
}

LightDescription MakeRigLight(const std::string& name, const Vector3& toLight, double intensity,
  ShadowKind shadow, double shadowBias, const Vector3& color = { 1.0, 1.0, 1.0 })
{
  LightDescription light;
  light.Name = name;
  light.Frame = LightFrame::Camera;
  light.Direction = Scaled(toLight, -1.0);
  light.Intensity = intensity;
  light.Diffuse = color;
  light.Shadow = shadow;
  light.ShadowBias = shadowBias;
  return light;
}

// One light of a rig brings the ambient light; the others only brighten.
LightDescription AsFill(LightDescription light)
{
  light.Ambient = { 0.0, 0.0, 0.0 };
  light.Specular = { 0.0, 0.0, 0.0 };
  return light;
}
}

//------------------------------------------------------------------------------
QString NameOfType(LightType type)
{
  switch (type)
  {
    case LightType::Directional:
      return QObject::tr("directional light");
    case LightType::Point:
      return QObject::tr("point light");
    case LightType::Spot:
      return QObject::tr("spot light");
    default:
      return QObject::tr("headlight");
  }
}

//------------------------------------------------------------------------------
QString NameOfLight(const SceneDescription& scene, std::size_t light)
{
  const LightDescription& description = scene.Lights[light];
  return description.Name.empty()
    ? QObject::tr("%1 %2").arg(NameOfType(description.Type)).arg(light + 1)
    : QString::fromStdString(description.Name);
}

//------------------------------------------------------------------------------
LightDescription MakeNewLight(
  const SceneDescription& scene, LightType type, const ViewFrame& view, double shadowBias)
{
  LightDescription light;
  light.Type = type;
  light.Name = FreeName(scene, NameOfType(type).toStdString());
  light.Shadow = ShadowKind::Soft;
  light.ShadowBias = shadowBias;
  light.Intensity = scene.Lights.empty() ? 1.0 : 0.6;
  light.Ambient = scene.Lights.empty() ? Vector3{ 1.0, 1.0, 1.0 } : Vector3{ 0.0, 0.0, 0.0 };
  // Half as far away as the eye, so that its nearness is seen.
  const double distance = 0.5 * Length(Difference(view.Position, view.FocalPoint));
  light.Position =
    Sum(view.FocalPoint, Scaled(UnitVector(ToWorld(UpperLeft, view)), std::max(distance, 1e-6)));
  TurnLight(light, view, UpperLeft);
  return light;
}

//------------------------------------------------------------------------------
LightDescription CopyOfLight(const SceneDescription& scene, std::size_t light)
{
  LightDescription copy = scene.Lights[light];
  copy.Name = FreeName(scene, NameOfLight(scene, light).toStdString());
  return copy;
}

//------------------------------------------------------------------------------
std::vector<LightRig> GetLightRigs(double bias)
{
  const auto make = [bias](const char* name, const Vector3& toLight, double intensity,
                      ShadowKind shadow, const Vector3& color = { 1.0, 1.0, 1.0 })
  { return MakeRigLight(name, toLight, intensity, shadow, bias, color); };
  const auto none = ShadowKind::None;
  const auto soft = ShadowKind::Soft;
  return {
    { QObject::tr("Headlight"),
      QObject::tr("One light at your eye: everything is lit, nothing is shadowed"),
      { make("headlight", { 0, 0, 1 }, 1.0, none) } },
    { QObject::tr("Key, fill and back light"),
      QObject::tr("A photographer's three lights: depth by the key's shadow, the fill opens it, "
                  "the back light draws the outline"),
      { make("key", { -0.6, 0.6, 0.75 }, 0.95, soft, { 1.0, 0.97, 0.92 }),
        AsFill(make("fill", { 0.8, 0.1, 0.6 }, 0.35, none, { 0.85, 0.92, 1.0 })),
        AsFill(make("back", { 0.4, 0.5, -0.8 }, 0.5, none)) } },
    { QObject::tr("Raking light"),
      QObject::tr("One light almost along the surface: small relief casts long shadows"),
      { make("rake", { -1.0, 0.25, 0.22 }, 1.1, soft),
        AsFill(make("fill", { 0, 0, 1 }, 0.15, none)) } },
    { QObject::tr("Studio"),
      QObject::tr("Large soft lights from both sides and from above: even, with gentle shadows"),
      { make("left", { -0.9, 0.3, 0.6 }, 0.5, soft),
        AsFill(make("right", { 0.9, 0.3, 0.6 }, 0.4, soft)),
        AsFill(make("top", { 0.0, 1.0, 0.35 }, 0.45, soft)),
        AsFill(make("front", { 0, 0, 1 }, 0.15, none)) } },
  };
}

//------------------------------------------------------------------------------
Vector3 DirectionToLight(const LightDescription& light, const ViewFrame& view)
{
  if (light.Type == LightType::Headlight)
  {
    return { 0.0, 0.0, 1.0 };
  }
  if (!HasPosition(light))
  {
    const Vector3 toLight = Scaled(UnitVector(light.Direction), -1.0);
    return light.Frame == LightFrame::Camera ? toLight : ToView(toLight, view);
  }
  const Vector3 toLight = Difference(WorldPosition(light, view), view.FocalPoint);
  return Length(toLight) > 0.0 ? ToView(UnitVector(toLight), view) : Vector3{ 0.0, 0.0, 1.0 };
}

//------------------------------------------------------------------------------
void TurnLight(LightDescription& light, const ViewFrame& view, const Vector3& toLight)
{
  const Vector3 toLightInWorld = UnitVector(ToWorld(toLight, view));
  if (HasPosition(light))
  {
    const double distance = Length(Difference(WorldPosition(light, view), view.FocalPoint));
    SetWorldPosition(light, view, Sum(view.FocalPoint, Scaled(toLightInWorld, distance)));
  }
  SetWorldDirection(light, view, Scaled(toLightInWorld, -1.0));
}

//------------------------------------------------------------------------------
void ChangeFrame(LightDescription& light, LightFrame frame, const ViewFrame& view)
{
  const Vector3 position = WorldPosition(light, view);
  const Vector3 direction =
    light.Frame == LightFrame::Camera ? ToWorld(light.Direction, view) : light.Direction;
  light.Frame = frame;
  SetWorldPosition(light, view, position);
  SetWorldDirection(light, view, direction);
}

//------------------------------------------------------------------------------
void AimLight(LightDescription& light, const ViewFrame& view, const Vector3& target)
{
  const Vector3 from = HasPosition(light)
    ? WorldPosition(light, view)
    : Sum(target, ToWorld(DirectionToLight(light, view), view));
  const Vector3 direction = Difference(target, from);
  if (Length(direction) > 0.0)
  {
    SetWorldDirection(light, view, UnitVector(direction));
  }
}

}
