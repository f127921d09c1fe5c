/**
 * @file    SceneMaterial.h
 * @brief   a scene's appearance: transfer functions, material, and the images that it names
 */

#ifndef SceneMaterial_h
#define SceneMaterial_h

#include "SceneDescription.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkImageData;
class vtkVolumeMaterial;

namespace penumbra
{

/// The images of an environment map, in its order. Empty: none.
using EnvironmentImages = std::vector<vtkSmartPointer<vtkImageData>>;

/**
 * Reads what images the material's reflection model shows.
 * @throw InputError where one cannot be read, or where they cannot be an environment map.
 */
EnvironmentImages ReadEnvironmentImages(const MaterialDescription& material);

/// Transfer functions and material of a resolved scene.
vtkSmartPointer<vtkVolumeMaterial> MakeVolumeMaterial(
  const SceneDescription& scene, const EnvironmentImages& environment);

/// Whether MakeVolumeMaterial makes the same of both scenes, with the same environment.
bool HaveSameMaterial(const SceneDescription& a, const SceneDescription& b);

}

#endif
