/**
 * @file ShadowedVolume.h
 * @brief A visibility filter with all that it needs, and what came out of it.
 */
#ifndef ShadowedVolume_h
#define ShadowedVolume_h

#include "SyntheticVolumes.h"

#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeProperty.h>
#include <vtkVolumeVisibilityFilter.h>

#include <functional>
#include <vector>

namespace penumbra
{
/// A volume without light: linear interpolation, unit distance 1, opacity 0. No soft shadow is
/// negligible.
struct ShadowedVolume
{
  vtkNew<vtkVolumeVisibilityFilter> Filter;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkSmartPointer<vtkImageData> Volume;

  explicit ShadowedVolume(vtkSmartPointer<vtkImageData> volume);

  /// The same extinction at every scalar.
  void SetExtinction(double extinction);
  /// A soft shadow of no bias.
  vtkSmartPointer<vtkVolumeLight> AddDirectional(const Point& towardsLight);
  vtkSmartPointer<vtkVolumeLight> AddPoint(const Point& position);

  /// One value for each point of the output, of one of its arrays.
  std::vector<float> Compute(int array = 0);
  /// Where those points are, in the volume's own coordinates.
  std::vector<Point> GetPoints();
};

/// A float volume that is 1 everywhere.
vtkSmartPointer<vtkImageData> MakeUniform(const VolumeGrid& grid);

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(double factor, const Point& vector);
double Length(const Point& vector);

/// Length of the way from a point within the grid's box to where it leaves the box.
double GetExit(const VolumeGrid& grid, const Point& from, const Point& direction);

/// Between values in the same places. Infinite where their numbers are not the same.
double GetLargestDifference(const std::vector<float>& a, const std::vector<float>& b);

/// Largest difference between values at the filter's points and a function of their positions.
double GetLargestError(ShadowedVolume& scene, const std::function<double(const Point&)>& expected);
}

#endif
