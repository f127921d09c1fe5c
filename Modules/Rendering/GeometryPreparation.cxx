#include "GeometryPreparation.h"

#include "DrawnScene.h"
#include "PictureRequest.h"

#include "vtkIlluminatedVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

namespace penumbra
{
namespace
{
// The camera's whole projection; VTK keeps its matrices transposed for OpenGL.
Matrix4 GetWorldToClip(vtkRenderer* renderer, vtkOpenGLCamera* camera)
{
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* viewToClip;
  vtkMatrix4x4* worldToClip;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  Matrix4 matrix;
  vtkMatrix4x4::Transpose(worldToClip->GetData(), matrix.data());
  return matrix;
}

void PlaceClippingPlanes(vtkPlaneCollection* planes, DrawnScene& scene)
{
  scene.ClippingPlanes.clear();
  const int count = planes ? planes->GetNumberOfItems() : 0;
  for (int plane = 0; plane < count; ++plane)
  {
    scene.ClippingPlanes.push_back(scene.Placement.GetPlane(planes->GetItem(plane)));
  }
}

void PlaceCropping(vtkVolumeMapper* mapper, vtkImageData* image, DrawnScene& scene)
{
  scene.AnythingVisible = true;
  scene.Cropping = CroppingKind::None;
  scene.CroppingFlags = 0;
  if (!mapper->GetCropping())
  {
    return;
  }
  scene.CroppingFlags = mapper->GetCroppingRegionFlags();
  ComputeCroppingPlanes(
    image, mapper->GetCroppingRegionPlanes(), scene.CroppingLow, scene.CroppingHigh);
  if (scene.CroppingFlags != VTK_CROP_SUBVOLUME)
  {
    scene.Cropping = CroppingKind::Regions;
    return;
  }
  scene.Cropping = CroppingKind::Box;
  scene.AnythingVisible = scene.Placement.CropBox(scene.CroppingLow, scene.CroppingHigh);
}
}

//------------------------------------------------------------------------------
std::string PrepareGeometry(const PictureRequest& request, DrawnScene& scene)
{
  if (!ComputeVolumePlacement(request.Image, request.Volume->GetMatrix(), scene.Placement))
  {
    return "The volume's spacing, direction or matrix has no inverse; it is not drawn.";
  }
  auto* camera = vtkOpenGLCamera::SafeDownCast(request.Renderer->GetActiveCamera());
  Vector3 eye;
  camera->GetPosition(eye.data());
  if (!ComputeViewRays(scene.Placement, GetWorldToClip(request.Renderer, camera), eye, scene.Rays))
  {
    return "The camera's projection has no inverse; the volume is not drawn.";
  }
  PlaceClippingPlanes(request.Mapper->GetClippingPlanes(), scene);
  PlaceCropping(request.Mapper, request.Image, scene);
  return {};
}

}
