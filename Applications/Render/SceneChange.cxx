#include "SceneChange.h"

#include "InputError.h"
#include "SceneRendering.h"
#include "Vector3.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <vector>

namespace penumbra
{
namespace
{
const double OneDegree = vtkMath::RadiansFromDegrees(1.0);
constexpr double FadedTo = 0.99;
constexpr double PartOfRange = 0.001;

Vector3 RotatedAbout(
  const Vector3& point, const Vector3& center, const Vector3& axis, double radians)
{
  return Sum(center, Rotated(Difference(point, center), axis, radians));
}

// A headlight and a light of the camera's frame turn away from it, and so leave it.
void TurnLight(SceneRendering& rendering)
{
  vtkVolumeLight* light = rendering.GetLights().front();
  rendering.DetachFromCamera(0);
  vtkCamera* camera = rendering.GetRenderer()->GetActiveCamera();
  Vector3 up;
  Vector3 center;
  Vector3 position;
  Vector3 target;
  camera->GetViewUp(up.data());
  camera->GetFocalPoint(center.data());
  light->GetPosition(position.data());
  light->GetFocalPoint(target.data());
  const Vector3 direction = Rotated(Difference(target, position), up, OneDegree);
  if (light->GetPositional())
  {
    position = RotatedAbout(position, center, up, OneDegree);
  }
  target = Sum(position, direction);
  light->SetPosition(position.data());
  light->SetFocalPoint(target.data());
}

void FadeLight(vtkVolumeLight* light)
{
  Vector3 color;
  light->GetDiffuseColor(color.data());
  light->SetDiffuseColor(Scaled(color, FadedTo).data());
  light->GetSpecularColor(color.data());
  light->SetSpecularColor(Scaled(color, FadedTo).data());
  light->GetAmbientColor(color.data());
  light->SetAmbientColor(Scaled(color, FadedTo).data());
}

void MoveOpacity(vtkVolume* volume)
{
  auto* mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  double range[2];
  mapper->GetInput()->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  vtkPiecewiseFunction* opacity = volume->GetProperty()->GetScalarOpacity();
  std::vector<std::array<double, 4>> nodes(static_cast<std::size_t>(opacity->GetSize()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    opacity->GetNodeValue(static_cast<int>(i), nodes[i].data());
  }
  // One by one, nodes would pass each other, and those at one scalar would change their order.
  opacity->RemoveAllPoints();
  for (const auto& [scalar, value, midpoint, sharpness] : nodes)
  {
    opacity->AddPoint(scalar + PartOfRange * (range[1] - range[0]), value, midpoint, sharpness);
  }
}
}

//------------------------------------------------------------------------------
void CheckChange(SceneChange change, std::size_t numberOfLights)
{
  const bool isOfLight = change == SceneChange::Light || change == SceneChange::LightColour;
  if (isOfLight && numberOfLights == 0)
  {
    throw InputError("--change needs a light to change, and the scene has none");
  }
}

//------------------------------------------------------------------------------
void ChangeScene(SceneRendering& rendering, SceneChange change)
{
  switch (change)
  {
    case SceneChange::Light:
      TurnLight(rendering);
      break;
    case SceneChange::LightColour:
      FadeLight(rendering.GetLights().front());
      break;
    case SceneChange::Opacity:
      MoveOpacity(rendering.GetVolume());
      break;
    case SceneChange::Camera:
      rendering.GetRenderer()->GetActiveCamera()->Azimuth(1.0);
      break;
  }
}

}
