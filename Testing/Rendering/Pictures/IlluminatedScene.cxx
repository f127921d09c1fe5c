#include "IlluminatedScene.h"

#include "RenderToImage.h"

#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
IlluminatedScene::IlluminatedScene(vtkImageData* image, int width, int height)
{
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetBackground(0.1, 0.1, 0.2);

  this->Opacity->AddPoint(60.0, 0.0);
  this->Opacity->AddPoint(120.0, 0.25);
  this->Opacity->AddPoint(255.0, 0.6);
  this->Color->AddRGBPoint(0.0, 0.9, 0.3, 0.2);
  this->Color->AddRGBPoint(128.0, 0.9, 0.6, 0.4);
  this->Color->AddRGBPoint(255.0, 1.0, 1.0, 0.9);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetScalarOpacity(this->Opacity);
  property->SetColor(this->Color);
  property->SetInterpolationTypeToLinear();
  property->SetAmbient(0.2);
  property->SetDiffuse(0.7);
  property->SetSpecular(0.3);
  property->SetSpecularPower(20.0);
  property->ShadeOn();

  this->Mapper->SetInputData(image);
  this->Mapper->SetShadowTechniqueToRays();
  this->Volume->SetMapper(this->Mapper);
  this->Renderer->AddVolume(this->Volume);

  double bounds[6];
  image->GetBounds(bounds);
  const double center[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  this->LookFrom(0.4, 0.3, 0.85, 1.9 * diagonal, center);
}

//------------------------------------------------------------------------------
vtkVolumeLight* IlluminatedScene::AddDirectionalLight(double x, double y, double z, int shadow)
{
  vtkNew<vtkVolumeLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(x, y, z);
  light->SetShadow(shadow);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkVolumeLight* IlluminatedScene::AddPointLight(double x, double y, double z, int shadow)
{
  vtkNew<vtkVolumeLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(x, y, z);
  light->SetShadow(shadow);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkVolumeLight* IlluminatedScene::GetLight()
{
  return vtkVolumeLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
}

//------------------------------------------------------------------------------
void IlluminatedScene::LookFrom(
  double x, double y, double z, double distance, const double target[3])
{
  const double factor = distance / std::hypot(x, y, z);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(target);
  camera->SetPosition(target[0] + factor * x, target[1] + factor * y, target[2] + factor * z);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(32.0);
  camera->SetClippingRange(0.01 * distance, 3.0 * distance);
}

//------------------------------------------------------------------------------
void IlluminatedScene::Shade(bool on)
{
  this->Volume->GetProperty()->SetShade(on);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> IlluminatedScene::Render()
{
  return RenderToImage(this->Window);
}

}
