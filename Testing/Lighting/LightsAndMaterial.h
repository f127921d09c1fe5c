/**
 * @file LightsAndMaterial.h
 * @brief A shaded scene, without a volume or a window, whose requirements tests ask for.
 */
#ifndef LightsAndMaterial_h
#define LightsAndMaterial_h

#include "LightingRequirements.h"

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkVolumeProperty.h>

#include <initializer_list>

namespace penumbra
{
struct LightsAndMaterial
{
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkLightCollection> lights;
  LightedScene scene;

  explicit LightsAndMaterial(std::initializer_list<vtkLight*> lightsOfScene = {})
  {
    for (vtkLight* light : lightsOfScene)
    {
      this->lights->AddItem(light);
    }
    this->property->ShadeOn();
    this->property->SetDiffuse(0.7);
    this->property->SetSpecular(0.3);
    this->scene.Property = this->property;
    this->scene.Lights = this->lights;
  }

  LightingRequirements Requirements() const { return ComputeLightingRequirements(this->scene); }
};
}

#endif
