/**
 * @file    SceneDefaults.h
 * @brief   the defaults that depend on the volume
 */

#ifndef SceneDefaults_h
#define SceneDefaults_h

#include "SceneDescription.h"
#include "VolumeStatistics.h"

class vtkImageData;

namespace penumbra
{

/**
 * Fills in every optional of the description that stands for a choice: transfer function, steps,
 * biases, shadow technique and camera. The scene that comes out depends on its arguments alone.
 * @throw InputError where the camera does not go with the volume.
 */
void ResolveScene(SceneDescription& scene, vtkImageData* image);

/**
 * Fills in what the transfer function does not say itself, from its preset, or where it has none,
 * from one that suits the voxels, of which `statistics` are.
 */
void ResolveTransferFunction(
  TransferFunctionDescription& function, vtkImageData* image, const VolumeStatistics& statistics);

}

#endif
