#include "PictureRays.h"

#include "ReferenceScene.h"

#include "vtkMath.h"
#include "vtkVectorOperators.h"

#include <cmath>

namespace penumbra::reference
{

//------------------------------------------------------------------------------
PictureRays::PictureRays(const ReferenceScene& scene)
  : IsParallel(scene.Camera->GetParallelProjection() != 0)
  , Eye(scene.Camera->GetPosition())
  , Forward(vtkVector3d(scene.Camera->GetFocalPoint()) - Eye)
  , Width(scene.Size[0])
  , Height(scene.Size[1])
  , WindowCenter(scene.Camera->GetWindowCenter())
{
  this->Forward.Normalize();
  this->Right = this->Forward.Cross(vtkVector3d(scene.Camera->GetViewUp())).Normalized();
  this->Up = this->Right.Cross(this->Forward);
  const double half = this->IsParallel
    ? scene.Camera->GetParallelScale()
    : std::tan(0.5 * vtkMath::RadiansFromDegrees(scene.Camera->GetViewAngle()));
  const bool isOfWidth = !this->IsParallel && scene.Camera->GetUseHorizontalViewAngle() != 0;
  this->HalfHeight = isOfWidth ? half * this->Height / this->Width : half;
  this->HalfWidth = this->HalfHeight * this->Width / this->Height;
}

//------------------------------------------------------------------------------
ViewRay PictureRays::GetRay(double x, double y) const
{
  const vtkVector3d offset =
    this->Right * ((2.0 * x / this->Width - 1.0 + this->WindowCenter[0]) * this->HalfWidth) +
    this->Up * ((2.0 * y / this->Height - 1.0 + this->WindowCenter[1]) * this->HalfHeight);
  if (this->IsParallel)
  {
    return { this->Eye + offset, this->Forward };
  }
  return { this->Eye, (this->Forward + offset).Normalized() };
}

}
