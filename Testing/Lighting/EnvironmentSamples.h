/**
 * @file EnvironmentSamples.h
 * @brief Environments in both forms of images, looked up and integrated without Penumbra's own
 * code.
 */
#ifndef EnvironmentSamples_h
#define EnvironmentSamples_h

#include "EnvironmentMap.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <vector>

namespace penumbra
{
using Direction = std::array<double, 3>;
/// Radiance from a direction of unit length.
using Environment = std::function<double(const Direction&)>;

/// Half an 8-bit step: what filtered maps may be off the integral.
constexpr double HalfStep = 0.5 / 255.0;

Direction Normalize(const Direction& v);
double Dot(const Direction& v, const Direction& w);

/// A place on a face of OpenGL's cube maps, 0 to 1.
struct FacePlace
{
  int face;
  double s;
  double t;
};
/// By the OpenGL specification's table.
FacePlace FindFacePlace(const Direction& direction);
/// Its inverse, of unit length.
Direction GetDirection(const FacePlace& place);
Direction GetEquirectangularDirection(double u, double v);

/// Linear filtering of the red channel across the edges, as OpenGL does it.
double Sample(const CubeMap& cube, const Direction& direction);

/// About evenly over the sphere, and the six axes.
std::vector<Direction> SpreadDirections(int count);

/// Images that own what they show; `values` has rows from the top, one value a pixel.
struct OwnedImages
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  std::vector<std::vector<double>> values;

  bool IsCube() const { return this->images.size() == 6; }
  /// The pixel's value that the direction falls on.
  double LookUp(const Direction& direction) const;
  EnvironmentMap MakeMap() const;
};

/// Each pixel has the value at its centre; floats in grey.
OwnedImages MakeEquirectangular(int width, int height, const Environment& environment);
OwnedImages MakeCubeFaces(int size, const Environment& environment);

/// A grey float image from values by rows from the top.
vtkSmartPointer<vtkImageData> MakeImage(int width, int height, const std::vector<double>& values);

/// integral of E max(R.w, 0)^n dw / integral of max(R.w, 0)^n dw, by samples^2 evenly drawn w.
double IntegrateLobe(const Environment& environment, const Direction& R, double n, int samples);
}

#endif
