#include "SyntheticVolumes.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
double Mix(const VolumeValues& values, double insideShare)
{
  return values.outside + (values.inside - values.outside) * insideShare;
}

double RepresentableValue(double value, vtkDataArray* scalars)
{
  if (scalars->GetDataType() == VTK_FLOAT || scalars->GetDataType() == VTK_DOUBLE)
  {
    return value;
  }
  return std::clamp(std::round(value), scalars->GetDataTypeMin(), scalars->GetDataTypeMax());
}
}

Point VolumeGrid::LastSample() const
{
  Point last = this->origin;
  for (int axis = 0; axis < 3; ++axis)
  {
    last[axis] += (this->dimensions[axis] - 1) * this->spacing[axis];
  }
  return last;
}

Point VolumeGrid::Center() const
{
  const Point last = this->LastSample();
  return { (this->origin[0] + last[0]) / 2, (this->origin[1] + last[1]) / 2,
    (this->origin[2] + last[2]) / 2 };
}

double VolumeGrid::InnerRadius() const
{
  const Point last = this->LastSample();
  return std::min(
           { last[0] - this->origin[0], last[1] - this->origin[1], last[2] - this->origin[2] }) /
    2;
}

double Distance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

vtkSmartPointer<vtkImageData> SampleField(const VolumeGrid& grid, const ScalarField& field)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(grid.dimensions.data());
  volume->SetSpacing(grid.spacing.data());
  volume->SetOrigin(grid.origin.data());
  volume->AllocateScalars(grid.scalarType, 1);
  vtkDataArray* scalars = volume->GetPointData()->GetScalars();
  for (vtkIdType index = 0; index < volume->GetNumberOfPoints(); ++index)
  {
    Point position;
    volume->GetPoint(index, position.data());
    scalars->SetComponent(index, 0, RepresentableValue(field(position), scalars));
  }
  return volume;
}

vtkSmartPointer<vtkImageData> MakeBall(
  const VolumeGrid& grid, double radius, double edge, const VolumeValues& values)
{
  const Point center = grid.Center();
  return SampleField(grid,
    [=](const Point& position)
    {
      const double depth = radius - Distance(position, center);
      const double share = edge > 0 ? depth / edge + 0.5 : (depth >= 0 ? 1.0 : 0.0);
      return Mix(values, std::clamp(share, 0.0, 1.0));
    });
}

vtkSmartPointer<vtkImageData> MakeSlab(
  const VolumeGrid& grid, int axis, double first, double last, const VolumeValues& values)
{
  return SampleField(grid,
    [=](const Point& position)
    {
      const bool inside = first <= position[axis] && position[axis] <= last;
      return inside ? values.inside : values.outside;
    });
}

vtkSmartPointer<vtkImageData> MakeRamp(const VolumeGrid& grid, int axis, const VolumeValues& values)
{
  const double first = grid.FirstSample()[axis];
  const double length = grid.LastSample()[axis] - first;
  return SampleField(
    grid, [=](const Point& position) { return Mix(values, (position[axis] - first) / length); });
}

vtkSmartPointer<vtkImageData> MakeShells(
  const VolumeGrid& grid, double period, const VolumeValues& values)
{
  const Point center = grid.Center();
  return SampleField(grid,
    [=](const Point& position)
    {
      const double phase = 2 * vtkMath::Pi() * Distance(position, center) / period;
      return Mix(values, (1 + std::cos(phase)) / 2);
    });
}

vtkSmartPointer<vtkImageData> MakeMarschnerLobb(const VolumeGrid& grid, const VolumeValues& values)
{
  constexpr double fM = 6.0;
  constexpr double alpha = 0.25;
  const Point center = grid.Center();
  const Point last = grid.LastSample();
  return SampleField(grid,
    [=](const Point& position)
    {
      Point p;
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = (position[axis] - center[axis]) / (last[axis] - center[axis]);
      }
      const double r = std::hypot(p[0], p[1]);
      const double rho = std::cos(2 * vtkMath::Pi() * fM * std::cos(vtkMath::Pi() * r / 2));
      const double value =
        (1 - std::sin(vtkMath::Pi() * p[2] / 2) + alpha * (1 + rho)) / (2 * (1 + alpha));
      return Mix(values, value);
    });
}
}
