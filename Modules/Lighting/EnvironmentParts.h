/**
 * @file    EnvironmentParts.h
 * @brief   which directions the pixels of an environment map show, and how much of the sphere
 */

#ifndef EnvironmentParts_h
#define EnvironmentParts_h

#include "EnvironmentMap.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace penumbra
{

/// From +y, and about it: atan2(z, x).
struct SphericalAngles
{
  double Polar;
  double Azimuth;
};

inline SphericalAngles GetAngles(const std::array<double, 3>& direction)
{
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  return { std::acos(std::clamp(direction[1] / length, -1.0, 1.0)),
    std::atan2(direction[2], direction[0]) };
}

/// The direction of a point of a cube map's face, a = 2 s - 1 and b = 2 t - 1, as in the OpenGL
/// specification's table; not of unit length.
inline std::array<double, 3> GetFaceDirection(int face, double a, double b)
{
  switch (face)
  {
    case 0:
      return { 1.0, -b, -a };
    case 1:
      return { -1.0, -b, a };
    case 2:
      return { a, 1.0, b };
    case 3:
      return { a, -1.0, -b };
    case 4:
      return { a, -b, 1.0 };
    default:
      return { -a, -b, -1.0 };
  }
}

/// For VisitParts: every pixel is one part.
constexpr double WholePixels = std::numeric_limits<double>::infinity();

/// Into how many parts, each way, a pixel of this extent is divided, for parts of at most that one.
inline int CountParts(double pixel, double largest)
{
  return std::max(1, static_cast<int>(std::ceil(pixel / largest)));
}

template <typename Visitor>
void VisitEquirectangular(const EnvironmentImage& image, double largest, Visitor visit)
{
  const double pi = vtkMath::Pi();
  const int rowParts = CountParts(pi / image.Height, largest);
  const int columnParts = CountParts(2.0 * pi / image.Width, largest);
  const double height = pi / image.Height / rowParts;
  const double width = 2.0 * pi / image.Width / columnParts;
  for (int row = 0; row < image.Height * rowParts; ++row)
  {
    const double polar = (row + 0.5) * height;
    const double solidAngle = 2.0 * std::sin(polar) * std::sin(0.5 * height) * width;
    const float* pixel =
      image.Pixels.data() + static_cast<std::size_t>(row / rowParts) * image.Width * 3;
    for (int column = 0; column < image.Width; ++column, pixel += 3)
    {
      for (int part = 0; part < columnParts; ++part)
      {
        const double azimuth = (column * columnParts + part + 0.5) * width - pi;
        visit(solidAngle, SphericalAngles{ polar, azimuth }, pixel);
      }
    }
  }
}

/// Of the rectangle from a face's centre to (a, b).
inline double GetSolidAngle(double a, double b)
{
  return std::atan2(a * b, std::sqrt(a * a + b * b + 1.0));
}

/// Of the parts of a face's row: the same on every face.
inline std::vector<double> GetSolidAngles(int row, int size)
{
  const double step = 2.0 / size;
  const double top = row * step - 1.0;
  std::vector<double> solidAngles(size);
  double left = GetSolidAngle(-1.0, top + step) - GetSolidAngle(-1.0, top);
  for (int column = 0; column < size; ++column)
  {
    const double a = (column + 1) * step - 1.0;
    const double right = GetSolidAngle(a, top + step) - GetSolidAngle(a, top);
    solidAngles[column] = right - left;
    left = right;
  }
  return solidAngles;
}

template <typename Visitor>
void VisitFaces(const std::vector<EnvironmentImage>& faces, double largest, Visitor visit)
{
  const int width = faces[0].Width;
  const int parts = CountParts(2.0 / width, largest);
  const int size = width * parts;
  for (int row = 0; row < size; ++row)
  {
    const std::vector<double> solidAngles = GetSolidAngles(row, size);
    const double b = (2.0 * row + 1.0) / size - 1.0;
    for (int face = 0; face < 6; ++face)
    {
      const float* pixels =
        faces[face].Pixels.data() + static_cast<std::size_t>(row / parts) * width * 3;
      for (int column = 0; column < size; ++column)
      {
        const double a = (2.0 * column + 1.0) / size - 1.0;
        visit(solidAngles[column], GetAngles(GetFaceDirection(face, a, b)),
          pixels + (column / parts) * 3);
      }
    }
  }
}

/// Calls visit(solid angle, angles, red-green-blue) for equal parts of each pixel, divided until
/// none is wider than this, in radians.
template <typename Visitor>
void VisitParts(const EnvironmentMap& map, double largest, Visitor visit)
{
  if (map.Images.size() == 1)
  {
    VisitEquirectangular(map.Images[0], largest, visit);
  }
  else
  {
    VisitFaces(map.Images, largest, visit);
  }
}

}

#endif
