#include "SceneLights.h"

#include "SceneCamera.h"

#include <vtkCamera.h>
#include <vtkVolumeLight.h>

namespace penumbra
{
namespace
{
constexpr double NoCone = 180.0;

void PlaceLight(vtkVolumeLight* light, const Vector3& position, const Vector3& direction)
{
  light->SetPosition(position[0], position[1], position[2]);
  const Vector3 target = Sum(position, direction);
  light->SetFocalPoint(target[0], target[1], target[2]);
}

// Only where a light is has a meaning for point and spot lights, only where it shines for
// directional ones and spots: the other of the two may hold anything.
Vector3 PositionOf(const LightDescription& light)
{
  return light.Type == LightType::Directional ? Vector3{ 0.0, 0.0, 0.0 } : light.Position;
}

Vector3 DirectionOf(const LightDescription& light)
{
  return light.Type == LightType::Point ? Vector3{ 0.0, 0.0, -1.0 } : UnitVector(light.Direction);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeLight> MakeLight(const LightDescription& description)
{
  auto light = vtkSmartPointer<vtkVolumeLight>::New();
  ApplyLight(description, light);
  return light;
}

//------------------------------------------------------------------------------
void ApplyLight(const LightDescription& description, vtkVolumeLight* light)
{
  light->SetSwitch(description.On);
  if (description.Type == LightType::Headlight)
  {
    light->SetLightTypeToHeadlight();
  }
  else
  {
    light->SetLightTypeToSceneLight();
    PlaceLight(light, PositionOf(description), DirectionOf(description));
  }
  light->SetPositional(description.Type == LightType::Point || description.Type == LightType::Spot);
  light->SetConeAngle(description.Type == LightType::Spot ? description.ConeAngle : NoCone);
  light->SetExponent(description.Exponent);
  const Vector3& attenuation = description.Attenuation;
  light->SetAttenuationValues(attenuation[0], attenuation[1], attenuation[2]);
  const Vector3& ambient = description.Ambient;
  const Vector3& diffuse = description.Diffuse;
  const Vector3& specular = description.Specular;
  light->SetAmbientColor(ambient[0], ambient[1], ambient[2]);
  light->SetDiffuseColor(diffuse[0], diffuse[1], diffuse[2]);
  light->SetSpecularColor(specular[0], specular[1], specular[2]);
  light->SetIntensity(description.Intensity);
  light->SetShadow(static_cast<int>(description.Shadow));
  light->SetOpacityThreshold(description.OpacityThreshold);
  light->SetShadowBias(description.ShadowBias.value_or(-1.0));
}

//------------------------------------------------------------------------------
void PlaceInCameraFrame(
  const LightDescription& description, vtkCamera* camera, vtkVolumeLight* light)
{
  const CameraAxes axes(camera);
  Vector3 position{};
  if (description.Type != LightType::Directional)
  {
    camera->GetPosition(position.data());
    position = Sum(position, axes.ToWorld(description.Position));
  }
  PlaceLight(light, position, axes.ToWorld(DirectionOf(description)));
}

}
