/**
 * @class   ClippingPlaneHandle
 * @brief   one clipping plane in the 3D view, to be pushed and turned
 */

#ifndef ClippingPlaneHandle_h
#define ClippingPlaneHandle_h

#include <vtkNew.h>

#include <cstddef>

class vtkClippingPlaneRepresentation;
class vtkImplicitPlaneWidget2;

namespace penumbra
{

class SceneDocument;
class VolumeView;

class ClippingPlaneHandle
{
public:
  /// Of the scene's plane of this number. The view has to outlive it.
  ClippingPlaneHandle(SceneDocument* document, VolumeView* view, std::size_t plane);
  ~ClippingPlaneHandle();

  /// Shows the plane as it is in the scene, which has to have it.
  void Refresh();

private:
  void TakePlane();

  SceneDocument* Document;
  VolumeView* View;
  std::size_t Plane;
  vtkNew<vtkImplicitPlaneWidget2> Widget;
  vtkNew<vtkClippingPlaneRepresentation> Shape;
};

}

#endif
