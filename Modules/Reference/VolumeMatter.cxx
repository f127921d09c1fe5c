#include "VolumeMatter.h"

#include "ReferenceScene.h"

#include <algorithm>

namespace penumbra::reference
{

//------------------------------------------------------------------------------
VolumeMatter::VolumeMatter(const ReferenceScene& scene)
  : Frame(scene.Volume, scene.Transform)
  , Field(scene.Volume)
  , Region(scene, Frame)
  , Extinction(scene.Property)
  , GradientOpacity(MakeGradientOpacity(scene.Property))
  , Occupied(Field, Extinction)
  , Estimator(scene.Gradient)
  , Nearest(scene.Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
{
  if (this->GradientOpacity)
  {
    for (const double level : this->GradientOpacity->GetLevels())
    {
      if (level >= 0.0)
      {
        this->SquaredLevels.push_back(level * level);
      }
    }
  }
}

//------------------------------------------------------------------------------
VoxelIndex VolumeMatter::GetNearestVoxel(const CellSpan& span) const
{
  const vtkVector3d middle = span.Start + span.Step * 0.5;
  VoxelIndex voxel;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Field.GetDimensions()[axis] - 1;
    voxel[axis] = std::min(span.Cell[axis] + (middle[axis] >= 0.5 ? 1 : 0), last);
  }
  return voxel;
}

//------------------------------------------------------------------------------
bool VolumeMatter::FillSpan(CellSpan& span) const
{
  if (this->Region.HasMask() && this->Region.IsMasked(this->GetNearestVoxel(span)))
  {
    return false;
  }
  if (this->Nearest)
  {
    span.Scalar = { { this->Field.At(this->GetNearestVoxel(span)) } };
  }
  else
  {
    span.Scalar = CellPath(span.Start, span.Step).Along(this->Field.GetCorners(span.Cell));
  }
  return true;
}

//------------------------------------------------------------------------------
SpanGradient VolumeMatter::GetGradient(const CellSpan& span) const
{
  SpanGradient gradient;
  if (this->Nearest)
  {
    const vtkVector3d atVoxel =
      this->Field.GetGradient(this->GetNearestVoxel(span), this->Estimator);
    for (int axis = 0; axis < 3; ++axis)
    {
      gradient[axis] = { { atVoxel[axis] } };
    }
    return gradient;
  }
  const CellPath path(span.Start, span.Step);
  const auto corners = this->Field.GetGradients(span.Cell, this->Estimator);
  for (int axis = 0; axis < 3; ++axis)
  {
    gradient[axis] = path.Along(corners[axis]);
  }
  return gradient;
}

//------------------------------------------------------------------------------
Polynomial<6> VolumeMatter::GetSquaredGradient(const SpanGradient& gradient) const
{
  std::array<Cubic, 3> own;
  for (int power = 0; power <= 3; ++power)
  {
    const vtkVector3d perLength = this->Frame.GradientToOwn({ gradient[0].Coefficients[power],
      gradient[1].Coefficients[power], gradient[2].Coefficients[power] });
    for (int axis = 0; axis < 3; ++axis)
    {
      own[axis].Coefficients[power] = perLength[axis] * this->Frame.GetMeanSpacing();
    }
  }
  Polynomial<6> squared;
  for (const Cubic& component : own)
  {
    Add(squared, Product(component, component));
  }
  return squared;
}

}
