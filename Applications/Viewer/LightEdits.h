/**
 * @file    LightEdits.h
 * @brief   lights added, copied, removed and arranged in a scene
 */

#ifndef LightEdits_h
#define LightEdits_h

#include "SceneDescription.h"

#include <QString>

#include <string>
#include <vector>

namespace penumbra
{

/// What people call it: "directional light", "point light" and so on.
QString NameOfType(LightType type);

/// "key", or where a light has no name its kind and number.
QString NameOfLight(const SceneDescription& scene, std::size_t light);

/// A camera's place, and its axes in the world.
struct ViewFrame
{
  Vector3 Position;
  Vector3 FocalPoint;
  Vector3 Right;
  Vector3 Up;
  Vector3 Backward;
};

/// A new light of this type with a soft shadow, from the upper left of what is seen, with a name
/// that no other has. Fixed in the scene, but for headlights.
LightDescription MakeNewLight(
  const SceneDescription& scene, LightType type, const ViewFrame& view, double shadowBias);

/// A copy with a name of its own.
LightDescription CopyOfLight(const SceneDescription& scene, std::size_t light);

struct LightRig
{
  QString Name;
  QString Tip;
  /// They follow the camera.
  std::vector<LightDescription> Lights;
};

/// Arrangements of lights that photographers and museums use.
std::vector<LightRig> GetLightRigs(double shadowBias);

/**
 * Where the light comes from, as seen: to the right, up and towards the viewer; of unit length.
 */
Vector3 DirectionToLight(const LightDescription& light, const ViewFrame& view);

/// Lets the light come from there. Point lights and spots keep their distance from what is looked
/// at; spots still shine at it.
void TurnLight(LightDescription& light, const ViewFrame& view, const Vector3& toLight);

/// Changes between the scene's and the camera's frame without a change of the picture.
void ChangeFrame(LightDescription& light, LightFrame frame, const ViewFrame& view);

/// Lets the light shine at a point of the world.
void AimLight(LightDescription& light, const ViewFrame& view, const Vector3& target);

}

#endif
