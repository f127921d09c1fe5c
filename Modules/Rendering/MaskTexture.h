/**
 * @file    MaskTexture.h
 * @brief   which voxels a mask shows, as a 3D texture
 */

#ifndef MaskTexture_h
#define MaskTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

class vtkImageData;
class vtkOpenGLRenderWindow;

namespace penumbra
{

class MaskTexture
{
public:
  /// Loads the mask where it has changed: 0 hides, all else shows. Null drops it. False where the
  /// graphics card cannot hold it.
  bool Update(vtkOpenGLRenderWindow* window, vtkImageData* mask);
  /// The one that is loaded, or null.
  vtkImageData* GetMask() const { return this->LoadedMask; }
  /// When the texture was last made or dropped.
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  vtkTextureObject* GetTexture() const { return this->Texture; }
  void Release(vtkOpenGLRenderWindow* window);

private:
  bool Load(vtkOpenGLRenderWindow* window, vtkImageData* mask);

  vtkNew<vtkTextureObject> Texture;
  vtkTimeStamp Time;
  vtkImageData* LoadedMask = nullptr;
};

}

#endif
