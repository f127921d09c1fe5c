/**
 * @file    StandInBox.h
 * @brief   the box that the stock ray caster draws in place of a volume
 *
 * The stock ray caster needs a volume to rasterize its box, read the depth of opaque geometry and
 * keep OpenGL's state. It is given a box of two voxels along each axis that covers the real volume:
 * what it would get wrong about the real one (single slices, mirroring matrices, NaN, more than six
 * lights) never reaches it, and no second copy of the voxels is uploaded.
 */

#ifndef StandInBox_h
#define StandInBox_h

#include "VolumePlacement.h"

#include "vtkNew.h"

class vtkImageData;
class vtkMatrix4x4;
class vtkOpenGLRenderPass;
class vtkRenderer;
class vtkVolume;
class vtkWindow;
class vtkGPUVolumeRayCastMapper;

namespace penumbra
{

class StandInBox
{
public:
  StandInBox();
  ~StandInBox();

  /// Places the box where the volume is.
  void Place(const VolumePlacement& placement);
  /// Maps the box's own coordinates to clip coordinates.
  Matrix4 GetBoxToClip(const Matrix4& textureToClip) const;
  /// One draw, its program and uniforms decided by the pass.
  void Draw(vtkRenderer* renderer, vtkOpenGLRenderPass* pass);
  void Release(vtkWindow* window);

private:
  vtkNew<vtkImageData> Image;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkGPUVolumeRayCastMapper> Mapper;
  Matrix4 BoxToTexture{};
};

}

#endif
