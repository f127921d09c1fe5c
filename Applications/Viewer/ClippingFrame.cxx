#include "ClippingFrame.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>

namespace penumbra
{
namespace
{
// Least part of an axis that a box keeps.
constexpr double LeastPart = 0.005;
}

//------------------------------------------------------------------------------
CroppingBox WholeBox(vtkImageData* image)
{
  CroppingBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = std::max(image->GetDimensions()[axis] - 1, 1);
    box[2 * axis] = image->GetOrigin()[axis];
    box[2 * axis + 1] = image->GetOrigin()[axis] + last * image->GetSpacing()[axis];
  }
  return box;
}

//------------------------------------------------------------------------------
CroppingBox KeptBox(const SceneDescription& scene, vtkImageData* image)
{
  return scene.Volume.Cropping ? *scene.Volume.Cropping : WholeBox(image);
}

//------------------------------------------------------------------------------
CroppingBox WithSideAt(const CroppingBox& box, int side, double place, const CroppingBox& whole)
{
  const int axis = side / 2;
  const double least = LeastPart * (whole[2 * axis + 1] - whole[2 * axis]);
  CroppingBox moved = box;
  moved[side] = side % 2 == 0 ? std::max(std::min(place, box[side + 1] - least), whole[side])
                              : std::min(std::max(place, box[side - 1] + least), whole[side]);
  return moved;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMatrix4x4> CroppingToWorld(const SceneDescription& scene, vtkImageData* image)
{
  vtkNew<vtkMatrix4x4> turned; // about the origin
  for (int row = 0; row < 3; ++row)
  {
    double place = image->GetOrigin()[row];
    for (int column = 0; column < 3; ++column)
    {
      const double element = image->GetDirectionMatrix()->GetElement(row, column);
      turned->SetElement(row, column, element);
      place -= element * image->GetOrigin()[column];
    }
    turned->SetElement(row, 3, place);
  }
  vtkNew<vtkMatrix4x4> transform;
  transform->DeepCopy(scene.Volume.Transform.data());
  auto toWorld = vtkSmartPointer<vtkMatrix4x4>::New();
  vtkMatrix4x4::Multiply4x4(transform, turned, toWorld);
  return toWorld;
}

}
