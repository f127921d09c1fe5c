#include "ShadowedVolume.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace penumbra
{
namespace
{
vtkSmartPointer<vtkVolumeLight> MakeSoftLight(const Point& position)
{
  auto light = vtkSmartPointer<vtkVolumeLight>::New();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetShadowToSoft();
  light->SetShadowBias(0.0);
  return light;
}
}

ShadowedVolume::ShadowedVolume(vtkSmartPointer<vtkImageData> volume)
  : Volume(std::move(volume))
{
  this->Property->SetScalarOpacity(this->Opacity);
  this->Property->SetInterpolationTypeToLinear();
  this->SetExtinction(0.0);
  this->Filter->SetInputData(this->Volume);
  this->Filter->SetVolumeProperty(this->Property);
  this->Filter->SetNegligibleVisibility(0.0);
}

void ShadowedVolume::SetExtinction(double extinction)
{
  this->Opacity->RemoveAllPoints();
  const double unitDistance = this->Property->GetScalarOpacityUnitDistance();
  this->Opacity->AddPoint(0.0, -std::expm1(-extinction * unitDistance));
}

vtkSmartPointer<vtkVolumeLight> ShadowedVolume::AddDirectional(const Point& towardsLight)
{
  const auto light = MakeSoftLight(towardsLight);
  this->Filter->AddLight(light);
  return light;
}

vtkSmartPointer<vtkVolumeLight> ShadowedVolume::AddPoint(const Point& position)
{
  const auto light = MakeSoftLight(position);
  light->PositionalOn();
  light->SetConeAngle(90.0);
  this->Filter->AddLight(light);
  return light;
}

std::vector<float> ShadowedVolume::Compute(int array)
{
  this->Filter->Update();
  vtkDataArray* values = this->Filter->GetOutput()->GetPointData()->GetArray(array);
  std::vector<float> result(values ? values->GetNumberOfTuples() : 0);
  for (std::size_t point = 0; point < result.size(); ++point)
  {
    result[point] = static_cast<float>(values->GetComponent(point, 0));
  }
  return result;
}

std::vector<Point> ShadowedVolume::GetPoints()
{
  this->Filter->Update();
  std::vector<Point> points(this->Filter->GetOutput()->GetNumberOfPoints());
  for (std::size_t point = 0; point < points.size(); ++point)
  {
    this->Filter->GetOutput()->GetPoint(point, points[point].data());
  }
  return points;
}

vtkSmartPointer<vtkImageData> MakeUniform(const VolumeGrid& grid)
{
  VolumeGrid floats = grid;
  floats.scalarType = VTK_FLOAT;
  return SampleField(floats, [](const Point&) { return 1.0; });
}

Point operator+(const Point& a, const Point& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Point operator-(const Point& a, const Point& b)
{
  return a + -1.0 * b;
}

Point operator*(double factor, const Point& vector)
{
  return { factor * vector[0], factor * vector[1], factor * vector[2] };
}

double Length(const Point& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

double GetExit(const VolumeGrid& grid, const Point& from, const Point& direction)
{
  const Point first = grid.FirstSample();
  const Point last = grid.LastSample();
  double exit = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double border = direction[axis] > 0.0 ? last[axis] : first[axis];
    if (direction[axis] != 0.0)
    {
      exit = std::min(exit, (border - from[axis]) / direction[axis] * Length(direction));
    }
  }
  return exit;
}

double GetLargestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double largest = a.size() == b.size() && !a.empty() ? 0.0 : infinity;
  for (std::size_t point = 0; point < std::min(a.size(), b.size()); ++point)
  {
    const double difference = std::abs(static_cast<double>(a[point]) - b[point]);
    largest = std::max(largest, std::isnan(difference) ? infinity : difference);
  }
  return largest;
}

double GetLargestError(ShadowedVolume& scene, const std::function<double(const Point&)>& expected)
{
  std::vector<float> values;
  for (const Point& point : scene.GetPoints())
  {
    values.push_back(static_cast<float>(expected(point)));
  }
  return GetLargestDifference(scene.Compute(), values);
}
}
