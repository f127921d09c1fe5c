#include "EnvironmentSamples.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace penumbra
{
namespace
{
const double Pi = vtkMath::Pi();

int FindPixel(double place, int size)
{
  return std::clamp(static_cast<int>(std::floor(place * size)), 0, size - 1);
}

double GetTexel(const CubeMap& cube, int face, int column, int row)
{
  return cube.Faces[face][(static_cast<std::size_t>(row) * cube.Size + column) * 3];
}

bool IsOutside(int index, int size)
{
  return index < 0 || index >= size;
}

/// Beyond one edge the texel of the face there, beyond a corner the mean of its three.
double GetTexelAround(const CubeMap& cube, int face, int column, int row)
{
  const int size = cube.Size;
  const bool beside = IsOutside(column, size);
  const bool above = IsOutside(row, size);
  if (beside && above)
  {
    const int inner[] = { std::clamp(column, 0, size - 1), std::clamp(row, 0, size - 1) };
    return (GetTexel(cube, face, inner[0], inner[1]) +
             GetTexelAround(cube, face, column, inner[1]) +
             GetTexelAround(cube, face, inner[0], row)) /
      3.0;
  }
  if (!beside && !above)
  {
    return GetTexel(cube, face, column, row);
  }
  const FacePlace place =
    FindFacePlace(GetDirection({ face, (column + 0.5) / size, (row + 0.5) / size }));
  return GetTexel(cube, place.face, FindPixel(place.s, size), FindPixel(place.t, size));
}

void AppendImage(
  OwnedImages& owned, int width, int height, const std::function<double(double, double)>& getValue)
{
  std::vector<double> values;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      values.push_back(getValue((column + 0.5) / width, (row + 0.5) / height));
    }
  }
  owned.images.push_back(MakeImage(width, height, values));
  owned.values.push_back(values);
}
}

//------------------------------------------------------------------------------
Direction Normalize(const Direction& v)
{
  const double length = std::sqrt(Dot(v, v));
  return { v[0] / length, v[1] / length, v[2] / length };
}

//------------------------------------------------------------------------------
double Dot(const Direction& v, const Direction& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

//------------------------------------------------------------------------------
FacePlace FindFacePlace(const Direction& r)
{
  const double size[] = { std::abs(r[0]), std::abs(r[1]), std::abs(r[2]) };
  const auto place = [](int face, double sc, double tc, double ma) -> FacePlace {
    return { face, 0.5 * (sc / ma + 1.0), 0.5 * (tc / ma + 1.0) };
  };
  if (size[0] >= size[1] && size[0] >= size[2])
  {
    return r[0] > 0.0 ? place(0, -r[2], -r[1], size[0]) : place(1, r[2], -r[1], size[0]);
  }
  if (size[1] >= size[2])
  {
    return r[1] > 0.0 ? place(2, r[0], r[2], size[1]) : place(3, r[0], -r[2], size[1]);
  }
  return r[2] > 0.0 ? place(4, r[0], -r[1], size[2]) : place(5, -r[0], -r[1], size[2]);
}

//------------------------------------------------------------------------------
Direction GetDirection(const FacePlace& place)
{
  const double sc = 2.0 * place.s - 1.0;
  const double tc = 2.0 * place.t - 1.0;
  const Direction directions[] = { { 1.0, -tc, -sc }, { -1.0, -tc, sc }, { sc, 1.0, tc },
    { sc, -1.0, -tc }, { sc, -tc, 1.0 }, { -sc, -tc, -1.0 } };
  return Normalize(directions[place.face]);
}

//------------------------------------------------------------------------------
Direction GetEquirectangularDirection(double u, double v)
{
  const double azimuth = 2.0 * Pi * (u - 0.5);
  const double elevation = Pi * (v - 0.5);
  return { std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
    std::cos(elevation) * std::sin(azimuth) };
}

//------------------------------------------------------------------------------
double Sample(const CubeMap& cube, const Direction& direction)
{
  const FacePlace place = FindFacePlace(direction);
  const double x = place.s * cube.Size - 0.5;
  const double y = place.t * cube.Size - 0.5;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  double sum = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      sum += (1.0 - std::abs(x - column - i)) * (1.0 - std::abs(y - row - j)) *
        GetTexelAround(cube, place.face, column + i, row + j);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<Direction> SpreadDirections(int count)
{
  std::vector<Direction> directions = { { 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.0, -1.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };
  for (int i = 0; i < count; ++i)
  {
    const double height = (2.0 * i + 1.0) / count - 1.0;
    const double turn = 2.399963 * i;
    const double radius = std::sqrt(1.0 - height * height);
    directions.push_back({ radius * std::cos(turn), height, radius * std::sin(turn) });
  }
  return directions;
}

//------------------------------------------------------------------------------
double OwnedImages::LookUp(const Direction& direction) const
{
  const int* size = this->images[0]->GetDimensions();
  FacePlace place{ 0, std::atan2(direction[2], direction[0]) / (2.0 * Pi) + 0.5,
    0.5 - std::asin(std::clamp(direction[1], -1.0, 1.0)) / Pi };
  if (this->IsCube())
  {
    place = FindFacePlace(direction);
  }
  return this
    ->values[place.face][FindPixel(place.t, size[1]) * size[0] + FindPixel(place.s, size[0])];
}

//------------------------------------------------------------------------------
EnvironmentMap OwnedImages::MakeMap() const
{
  std::string reason;
  const std::vector<vtkImageData*> pointers(this->images.begin(), this->images.end());
  return MakeEnvironmentMap(pointers, reason).value();
}

//------------------------------------------------------------------------------
OwnedImages MakeEquirectangular(int width, int height, const Environment& environment)
{
  OwnedImages owned;
  AppendImage(owned, width, height,
    [&](double u, double down) { return environment(GetEquirectangularDirection(u, 1.0 - down)); });
  return owned;
}

//------------------------------------------------------------------------------
OwnedImages MakeCubeFaces(int size, const Environment& environment)
{
  OwnedImages owned;
  for (int face = 0; face < 6; ++face)
  {
    AppendImage(owned, size, size,
      [&](double s, double t) {
        return environment(GetDirection({ face, s, t }));
      });
  }
  return owned;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(int width, int height, const std::vector<double>& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* scalars = static_cast<float*>(image->GetScalarPointer());
  for (int row = 0; row < height; ++row)
  {
    const auto top = values.begin() + static_cast<std::ptrdiff_t>(row) * width;
    std::copy(top, top + width, scalars + static_cast<std::ptrdiff_t>(height - 1 - row) * width);
  }
  return image;
}

//------------------------------------------------------------------------------
double IntegrateLobe(const Environment& environment, const Direction& R, double n, int samples)
{
  double across[3];
  double along[3];
  vtkMath::Perpendiculars(R.data(), across, along, 0.0);
  double sum = 0.0;
  for (int i = 0; i < samples; ++i)
  {
    const double cosine = std::pow((i + 0.5) / samples, 1.0 / (n + 1.0));
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (int j = 0; j < samples; ++j)
    {
      const double turn = 2.0 * Pi * (j + 0.618034 * i) / samples;
      Direction w;
      for (int k = 0; k < 3; ++k)
      {
        w[k] = cosine * R[k] + sine * (std::cos(turn) * across[k] + std::sin(turn) * along[k]);
      }
      sum += environment(w);
    }
  }
  return sum / samples / samples;
}
}
