#include "PlacedVolume.h"

#include <vtkNew.h>
#include <vtkTransform.h>

namespace penumbra
{
namespace
{
using Extent = std::array<int, 6>;

vtkSmartPointer<vtkImageData> MakeImage(
  const Extent& extent, const Vector3& spacing, const Vector3& origin)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(extent.data()));
  image->SetSpacing(spacing.data());
  image->SetOrigin(origin.data());
  return image;
}

vtkSmartPointer<vtkMatrix4x4> Turned(double angle, double x, double y, double z)
{
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(angle, x, y, z);
  return transform->GetMatrix();
}

vtkSmartPointer<vtkMatrix4x4> Multiplied(vtkMatrix4x4* first, const Vector3& scale)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(3.0, -2.0, 1.0);
  transform->Concatenate(first);
  transform->Scale(scale.data());
  return transform->GetMatrix();
}

void SetDirection(vtkImageData* image, vtkMatrix4x4* matrix, double sign)
{
  double direction[9];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction[3 * row + column] = matrix->GetElement(row, column) * (column == 0 ? sign : 1.0);
    }
  }
  image->SetDirectionMatrix(direction);
}

std::vector<PlacedVolume> MakeImages()
{
  const Extent extent = { 0, 11, 0, 8, 0, 14 };
  const Vector3 uneven = { 0.7, 1.3, 2.9 };
  const Vector3 origin = { 4.0, -7.0, 9.0 };
  std::vector<PlacedVolume> volumes = {
    { "plain", MakeImage(extent, { 1.0, 1.0, 1.0 }, { 0.0, 0.0, 0.0 }), nullptr },
    { "anisotropic", MakeImage(extent, uneven, origin), nullptr },
    { "turned", MakeImage(extent, uneven, origin), nullptr },
    { "mirrored", MakeImage(extent, uneven, origin), nullptr },
    { "extent", MakeImage({ 5, 16, -3, 5, 100, 114 }, uneven, origin), nullptr },
    { "slice", MakeImage({ 0, 11, 3, 3, 0, 14 }, uneven, origin), nullptr },
    { "voxel", MakeImage({ 0, 0, 0, 0, 7, 7 }, uneven, origin), nullptr },
    { "tiny", MakeImage(extent, { 0.7e-3, 1.3e-3, 2.9e-3 }, origin), nullptr },
    { "huge", MakeImage(extent, { 0.7e3, 1.3e3, 2.9e3 }, origin), nullptr },
    { "far", MakeImage(extent, uneven, { 1e5, -1e5, 1e5 }), nullptr },
  };
  SetDirection(volumes[2].image, Turned(50.0, 1.0, 2.0, -1.0), 1.0);
  SetDirection(volumes[3].image, Turned(140.0, 3.0, -1.0, 1.0), -1.0);
  return volumes;
}

std::vector<PlacedVolume> MakeActors()
{
  vtkNew<vtkMatrix4x4> identity;
  const auto turned = Turned(70.0, 0.5, -1.0, 2.0);
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 1, 0.6);
  shear->SetElement(2, 0, -0.8);
  return {
    { "as it is", nullptr, identity.Get() },
    { "turned", nullptr, Multiplied(turned, { 1.0, 1.0, 1.0 }) },
    { "mirrored", nullptr, Multiplied(turned, { 1.0, -1.0, 1.0 }) },
    { "scaled", nullptr, Multiplied(turned, { 0.5, 2.0, 3.0 }) },
    { "sheared", nullptr, Multiplied(shear, { 1.0, 1.5, 1.0 }) },
  };
}
}

//------------------------------------------------------------------------------
std::vector<PlacedVolume> MakePlacedVolumes()
{
  std::vector<PlacedVolume> volumes;
  for (const PlacedVolume& image : MakeImages())
  {
    for (const PlacedVolume& actor : MakeActors())
    {
      volumes.push_back({ image.name + ", actor " + actor.name, image.image, actor.actorMatrix });
    }
  }
  return volumes;
}

}
