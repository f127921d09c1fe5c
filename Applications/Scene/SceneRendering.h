/**
 * @class   SceneRendering
 * @brief   a described scene as VTK's renderer, volume, mapper, lights and camera
 *
 * The renderer can be added to any window. Before each of its renders the lights of the camera's
 * frame follow the camera and the clipping range follows the volume.
 */

#ifndef SceneRendering_h
#define SceneRendering_h

#include "SceneDescription.h"
#include "SceneVolume.h"
#include "VolumeBox.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkIlluminatedVolumeMapper;
class vtkRenderer;
class vtkVolume;
class vtkVolumeLight;

namespace penumbra
{

class SceneRendering
{
public:
  /// `scene` must be resolved (see SceneDefaults.h).
  SceneRendering(const SceneDescription& scene, const SceneVoxels& voxels);
  ~SceneRendering();
  SceneRendering(const SceneRendering&) = delete;
  SceneRendering& operator=(const SceneRendering&) = delete;

  /**
   * Shows another resolved scene of the same voxels and the same renderer, all but its camera. What
   * is as it was is not modified, and nothing computed from it is computed again.
   */
  void Update(const SceneDescription& scene, const EnvironmentImages& environment);

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkVolume* GetVolume() const { return this->Volume; }

  /// Null where the scene asks for the stock mapper.
  vtkIlluminatedVolumeMapper* GetIlluminatedMapper() const;

  /// One light for each of the description's, in its order.
  const std::vector<vtkSmartPointer<vtkVolumeLight>>& GetLights() const { return this->Lights; }

  /// From now on the light keeps its place in the world when the camera moves.
  void DetachFromCamera(std::size_t light);

  /// What the renderer cannot do of the scene, one sentence each.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

private:
  void SetTransform();
  void SetSurroundings();
  void SetLights();
  void PrepareFrame();

  SceneDescription Scene;
  vtkSmartPointer<vtkImageData> Image;
  VolumeBox Box;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  std::vector<vtkSmartPointer<vtkVolumeLight>> Lights;
  std::vector<std::string> Warnings;
  unsigned long ObserverOfFrames = 0;
};

}

#endif
