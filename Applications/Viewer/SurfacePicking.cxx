#include "SurfacePicking.h"

#include "VolumeBox.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr double HalfOpacity = 0.5;
constexpr double LargestOpacity = 0.9999;

class Ray
{
public:
  Ray(const SceneDescription& scene, vtkImageData* image)
    : Scene(scene)
    , Image(image)
  {
    vtkNew<vtkMatrix4x4> toWorld;
    toWorld->DeepCopy(scene.Volume.Transform.data());
    vtkMatrix4x4::Invert(toWorld, this->ToVolume);
    for (const auto& [x, y] : *scene.TransferFunction.Opacity)
    {
      this->Opacity->AddPoint(x, y);
    }
  }

  // Per unit distance; 0 outside of what is shown.
  double OpacityAt(const Vector3& world) const
  {
    for (const ClippingPlaneDescription& plane : this->Scene.ClippingPlanes)
    {
      if (Dot(Difference(world, plane.Origin), plane.Normal) < 0.0)
      {
        return 0.0;
      }
    }
    const double homogeneous[4] = { world[0], world[1], world[2], 1.0 };
    double place[4];
    this->ToVolume->MultiplyPoint(homogeneous, place);
    double index[3];
    this->Image->TransformPhysicalPointToContinuousIndex(place, index);
    int voxel[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = static_cast<int>(std::lround(index[axis]));
      if (voxel[axis] < 0 || voxel[axis] >= this->Image->GetDimensions()[axis] ||
        !this->IsInBox(axis, index[axis]))
      {
        return 0.0;
      }
    }
    const vtkIdType point = this->Image->ComputePointId(voxel);
    return this->Opacity->GetValue(
      this->Image->GetPointData()->GetScalars()->GetComponent(point, 0));
  }

private:
  bool IsInBox(int axis, double index) const
  {
    const auto& box = this->Scene.Volume.Cropping;
    const double place = this->Image->GetOrigin()[axis] + index * this->Image->GetSpacing()[axis];
    return !box || (place >= (*box)[2 * axis] && place <= (*box)[2 * axis + 1]);
  }

  const SceneDescription& Scene;
  vtkImageData* Image;
  vtkNew<vtkMatrix4x4> ToVolume;
  vtkNew<vtkPiecewiseFunction> Opacity;
};
}

//------------------------------------------------------------------------------
std::optional<Vector3> FindSurface(
  const SceneDescription& scene, vtkImageData* image, const Vector3& eye, const Vector3& direction)
{
  const Ray ray(scene, image);
  const Vector3 unit = UnitVector(direction);
  double nearest = 1e300;
  double farthest = 0.0;
  const VolumeBox box(image, scene.Volume.Transform);
  for (const Vector3& corner : box.GetCorners())
  {
    const double depth = Length(Difference(corner, eye));
    farthest = std::max(farthest, depth);
    nearest = std::min(nearest, Dot(Difference(corner, eye), unit));
  }
  const double step = 0.5 * SmallestSpacing(image);
  const double steps = step / *scene.TransferFunction.OpacityUnitDistance;
  double transparency = 1.0;
  for (double depth = std::max(nearest, 0.0); depth < farthest; depth += step)
  {
    const Vector3 place = Sum(eye, Scaled(unit, depth));
    const double opacity = std::min(ray.OpacityAt(place), LargestOpacity);
    transparency *= std::pow(1.0 - opacity, steps);
    if (transparency < 1.0 - HalfOpacity)
    {
      return place;
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<Vector3> FindSurfaceAt(const SceneDescription& scene, vtkImageData* image,
  vtkRenderer* renderer, const std::array<double, 2>& pixel)
{
  const auto toWorld = [&](double depth)
  {
    double point[4];
    renderer->SetDisplayPoint(pixel[0], pixel[1], depth);
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(point);
    return Vector3{ point[0] / point[3], point[1] / point[3], point[2] / point[3] };
  };
  const Vector3 near = toWorld(0.0);
  return FindSurface(scene, image, near, Difference(toWorld(1.0), near));
}

}
