#include "SceneSections.h"

#include "InputError.h"
#include "SceneCamera.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
constexpr NumberRange ViewAngles{ 0.0, 180.0, false, false };
}

//------------------------------------------------------------------------------
CameraDescription ParseCamera(const nlohmann::json& value)
{
  CameraDescription camera;
  JsonObject object(value, "camera");
  object.Read("position", camera.Position, AnyNumber);
  object.Read("focalPoint", camera.FocalPoint, AnyNumber);
  object.Read("viewUp", camera.ViewUp, AnyNumber);
  object.Read("viewAngle", camera.ViewAngle, ViewAngles);
  object.Read("parallelScale", camera.ParallelScale, MoreThanZero);
  object.RefuseUnknownKeys();
  CheckView(camera);
  return camera;
}

}
