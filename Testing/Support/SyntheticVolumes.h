/**
 * @file SyntheticVolumes.h
 * @brief Volumes whose value at every point is known in closed form.
 *
 * Positions and lengths are in the volume's own coordinates: origin + index * spacing. Integer
 * types take the nearest value that they can hold.
 */
#ifndef SyntheticVolumes_h
#define SyntheticVolumes_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <functional>

namespace penumbra
{
using Point = std::array<double, 3>;

double Distance(const Point& a, const Point& b);

struct VolumeGrid
{
  std::array<int, 3> dimensions = { 32, 32, 32 };
  Point spacing = { 1.0, 1.0, 1.0 };
  Point origin = { 0.0, 0.0, 0.0 };
  int scalarType = VTK_UNSIGNED_CHAR;

  Point FirstSample() const { return this->origin; }
  Point LastSample() const;
  Point Center() const;
  /// The shortest distance from the centre to a face that passes through the outermost samples.
  double InnerRadius() const;
};

/// The two values that a shape is made of.
struct VolumeValues
{
  double inside = 255.0;
  double outside = 0.0;
};

using ScalarField = std::function<double(const Point&)>;

vtkSmartPointer<vtkImageData> SampleField(const VolumeGrid& grid, const ScalarField& field);

/**
 * A ball about the centre of the grid. Its edge is a linear ramp, `edge` wide, half of it on either
 * side of the radius; with an edge of 0 it is a step.
 */
vtkSmartPointer<vtkImageData> MakeBall(
  const VolumeGrid& grid, double radius, double edge, const VolumeValues& values = {});

/// Inside where first <= position along the axis <= last.
vtkSmartPointer<vtkImageData> MakeSlab(
  const VolumeGrid& grid, int axis, double first, double last, const VolumeValues& values = {});

/// Linear along the axis: `outside` at its first sample, `inside` at its last.
vtkSmartPointer<vtkImageData> MakeRamp(
  const VolumeGrid& grid, int axis, const VolumeValues& values = {});

/**
 * Concentric shells about the centre of the grid: at the distance r,
 * outside + (inside - outside) * (1 + cos(2 pi r / period)) / 2.
 */
vtkSmartPointer<vtkImageData> MakeShells(
  const VolumeGrid& grid, double period, const VolumeValues& values = {});

/**
 * The test signal of Marschner and Lobb, "An evaluation of reconstruction filters for volume
 * rendering", Visualization 1994, with their fM = 6 and alpha = 0.25; its cube [-1, 1]^3 is
 * stretched between the first and the last samples, its range [0, 1] from outside to inside.
 */
vtkSmartPointer<vtkImageData> MakeMarschnerLobb(
  const VolumeGrid& grid, const VolumeValues& values = {});
}

#endif
