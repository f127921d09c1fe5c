/**
 * @file ReflectingScene.h
 * @brief One scene for all reflection models: a rounded shape with a soft shadow on itself.
 */
#ifndef ReflectingScene_h
#define ReflectingScene_h

#include "IlluminatedScene.h"

#include <vtkVolumeMaterial.h>

#include <functional>
#include <memory>

namespace penumbra
{
/// The scene with a Phong material, before `change` makes it another.
std::unique_ptr<IlluminatedScene> MakeReflectingScene(
  const std::function<void(vtkVolumeMaterial*)>& change);

vtkVolumeMaterial* GetMaterial(IlluminatedScene& scene);

/// 64 x 32 pixels of a blue sky with a bright spot above brown ground.
vtkSmartPointer<vtkImageData> MakeSky();
}

#endif
