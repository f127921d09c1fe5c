/**
 * @class   ClippingBoxHandle
 * @brief   the clipping box in the 3D view, whose sides are dragged by balls
 */

#ifndef ClippingBoxHandle_h
#define ClippingBoxHandle_h

#include <vtkNew.h>

class vtkBoxRepresentation;
class vtkBoxWidget2;

namespace penumbra
{

class SceneDocument;
class VolumeView;

class ClippingBoxHandle
{
public:
  /// The view has to outlive it.
  ClippingBoxHandle(SceneDocument* document, VolumeView* view);
  ~ClippingBoxHandle();

  /// Shows the scene's box, where it has one.
  void Refresh(bool shown);

private:
  void TakeBox();

  SceneDocument* Document;
  VolumeView* View;
  vtkNew<vtkBoxWidget2> Widget;
  vtkNew<vtkBoxRepresentation> Box;
};

}

#endif
