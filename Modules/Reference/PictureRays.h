/**
 * @file    PictureRays.h
 * @brief   the view rays of a camera's picture
 */

#ifndef PictureRays_h
#define PictureRays_h

#include "vtkVector.h"

namespace penumbra
{
struct ReferenceScene;
}

namespace penumbra::reference
{

/// In the world.
struct ViewRay
{
  vtkVector3d Start;
  /// Of unit length.
  vtkVector3d Direction;
};

class PictureRays
{
public:
  explicit PictureRays(const ReferenceScene& scene);

  /// Through a point of the picture in pixels from its lower left corner; the first pixel's middle
  /// is (0.5, 0.5).
  ViewRay GetRay(double x, double y) const;

private:
  bool IsParallel;
  vtkVector3d Eye;
  vtkVector3d Forward;
  vtkVector3d Right;
  vtkVector3d Up;
  double Width;
  double Height;
  /// Of half the picture, at the distance 1 or, in parallel projection, at any.
  double HalfWidth = 1.0;
  double HalfHeight = 1.0;
  vtkVector2d WindowCenter;
};

}

#endif
