/**
 * @file    PictureRequest.h
 * @brief   what one call of Render() is to draw, and by whose settings
 */

#ifndef PictureRequest_h
#define PictureRequest_h

class vtkDataArray;
class vtkIlluminatedVolumeMapper;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkVolumeProperty;

namespace penumbra
{

/// None is null.
struct PictureRequest
{
  vtkIlluminatedVolumeMapper* Mapper = nullptr;
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkVolume* Volume = nullptr;
  vtkVolumeProperty* Property = nullptr; ///< the volume's
  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr; ///< the image's array that is drawn
  bool Moving = false;             ///< one of many pictures, each to be drawn in time
};

}

#endif
