#include "VolumeBox.h"

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>

#include <algorithm>

namespace penumbra
{

//------------------------------------------------------------------------------
VolumeBox::VolumeBox(vtkImageData* image, const std::array<double, 16>& transform)
{
  const int* extent = image->GetExtent();
  double toWorld[16];
  vtkMatrix4x4::Multiply4x4(
    transform.data(), image->GetIndexToPhysicalMatrix()->GetData(), toWorld);
  for (int corner = 0; corner < 8; ++corner)
  {
    double index[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = (corner >> axis) & 1;
      const bool isSlice = extent[2 * axis] == extent[2 * axis + 1];
      index[axis] = extent[2 * axis + side] + (isSlice ? side - 0.5 : 0.0);
    }
    double world[4];
    vtkMatrix4x4::MultiplyPoint(toWorld, index, world);
    this->Corners[corner] = { world[0], world[1], world[2] };
  }
}

//------------------------------------------------------------------------------
Vector3 VolumeBox::GetCenter() const
{
  return Scaled(Sum(this->Corners.front(), this->Corners.back()), 0.5);
}

//------------------------------------------------------------------------------
double SmallestSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return std::min({ spacing[0], spacing[1], spacing[2] });
}

//------------------------------------------------------------------------------
double MeanSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return (spacing[0] + spacing[1] + spacing[2]) / 3.0;
}

}
