#include "CameraKeys.h"

#include <Qt>

#include <vtkCamera.h>

namespace penumbra
{
namespace
{
constexpr double KeyDegrees = 5.0;
constexpr double KeyZoom = 1.1;

void Zoom(vtkCamera* camera, double factor)
{
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }
  else
  {
    camera->Dolly(factor);
  }
}
}

//------------------------------------------------------------------------------
bool MoveByKey(int key, vtkCamera* camera)
{
  switch (key)
  {
    case Qt::Key_Left:
      camera->Azimuth(KeyDegrees);
      break;
    case Qt::Key_Right:
      camera->Azimuth(-KeyDegrees);
      break;
    case Qt::Key_Up:
      camera->Elevation(-KeyDegrees);
      break;
    case Qt::Key_Down:
      camera->Elevation(KeyDegrees);
      break;
    case Qt::Key_Plus:
      Zoom(camera, KeyZoom);
      break;
    case Qt::Key_Minus:
      Zoom(camera, 1.0 / KeyZoom);
      break;
    default:
      return false;
  }
  camera->OrthogonalizeViewUp();
  return true;
}

}
