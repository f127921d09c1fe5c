#include "EnvironmentHarmonics.h"
#include "EnvironmentMap.h"
#include "EnvironmentParts.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
using Color = std::array<double, 3>;

// In columns of the grid: a part's flux counts at its centre.
constexpr double LargestPart = 0.7;

struct Range
{
  Color Low;
  Color High;
};

/// Weights of the cubic polynomial through the values at -1, 0, 1 and 2 (Lagrange).
std::array<double, 4> GetCubicWeights(double x)
{
  return { -x * (x - 1.0) * (x - 2.0) / 6.0, (x + 1.0) * (x - 1.0) * (x - 2.0) / 2.0,
    -(x + 1.0) * x * (x - 2.0) / 2.0, (x + 1.0) * x * (x - 1.0) / 6.0 };
}

/// Calls visit(index, weight) for the 16 values of the grid that a smooth function's value in a
/// direction is interpolated from. Beyond a pole lies the other side.
template <typename Visitor>
void VisitStencil(const SphereGrid& grid, const SphericalAngles& angles, Visitor visit)
{
  const double y = angles.Polar / vtkMath::Pi() * grid.Rings - 0.5;
  const double x = (0.5 * angles.Azimuth / vtkMath::Pi() + 0.5) * grid.Columns - 0.5;
  const auto firstRing = static_cast<int>(std::floor(y));
  const auto firstColumn = static_cast<int>(std::floor(x));
  const std::array<double, 4> ringWeights = GetCubicWeights(y - firstRing);
  const std::array<double, 4> columnWeights = GetCubicWeights(x - firstColumn);
  for (int i = 0; i < 4; ++i)
  {
    int ring = firstRing + i - 1;
    const bool beyond = ring < 0 || ring >= grid.Rings;
    ring = ring < 0 ? -1 - ring : ring >= grid.Rings ? 2 * grid.Rings - 1 - ring : ring;
    const int turn = grid.Columns - 1 + (beyond ? grid.Columns / 2 : 0);
    for (int j = 0; j < 4; ++j)
    {
      const int column = (firstColumn + j + turn) & (grid.Columns - 1);
      visit(ring * grid.Columns + column, ringWeights[i] * columnWeights[j]);
    }
  }
}

/**
 * The flux of the map less its mean, spread over the grid so that any function that the grid
 * resolves has the same integral with it as with the map. Without the mean a uniform map is exactly
 * zero, and its blur exactly uniform.
 */
void Deposit(const EnvironmentMap& map, const Color& mean, SphereGrid& grid)
{
  const double columnWidth = 2.0 * vtkMath::Pi() / grid.Columns;
  VisitParts(map, LargestPart * columnWidth,
    [&](double solidAngle, const SphericalAngles& angles, const float* radiance)
    {
      const Color flux = { solidAngle * (radiance[0] - mean[0]),
        solidAngle * (radiance[1] - mean[1]), solidAngle * (radiance[2] - mean[2]) };
      VisitStencil(grid, angles,
        [&](int index, double weight)
        {
          for (int channel = 0; channel < 3; ++channel)
          {
            grid.Values[index][channel] += weight * flux[channel];
          }
        });
    });
}

Color Interpolate(const SphereGrid& grid, const SphericalAngles& angles)
{
  Color sum{};
  VisitStencil(grid, angles,
    [&](int index, double weight)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        sum[channel] += weight * grid.Values[index][channel];
      }
    });
  return sum;
}

Range FindRange(const EnvironmentMap& map)
{
  Range range;
  for (int channel = 0; channel < 3; ++channel)
  {
    range.Low[channel] = range.High[channel] = map.Images[0].Pixels[channel];
  }
  for (const EnvironmentImage& image : map.Images)
  {
    for (std::size_t i = 0; i < image.Pixels.size(); ++i)
    {
      const double value = image.Pixels[i];
      range.Low[i % 3] = std::min(range.Low[i % 3], value);
      range.High[i % 3] = std::max(range.High[i % 3], value);
    }
  }
  return range;
}

/// The power of two that gives the highest degree's waves five columns each.
int GetNumberOfColumns(std::size_t factors)
{
  int columns = 16;
  while (columns < 5 * static_cast<int>(factors))
  {
    columns *= 2;
  }
  return columns;
}

/// Linear interpolation between texels of an eighth of the lobe's width is accurate enough, but
/// across the faces' edges OpenGL's needs a quarter of that, which faces of up to 256 texels are
/// given. For n < 1 results can have kinks, however wide the lobe.
int GetFaceSize(double power)
{
  const double texels = 16.0 * std::sqrt(power + 1.0);
  const double size = power < 1.0 ? 256.0 : std::max(texels, std::min(4.0 * texels, 256.0));
  return static_cast<int>(std::ceil(std::min(size, 512.0)));
}

/// Mean and grid together; a mean of values lies between the least and the greatest of them.
CubeMap MakeCubeMap(const SphereGrid& grid, const Color& mean, const Range& range, int size)
{
  CubeMap cube;
  cube.Size = size;
  for (auto& face : cube.Faces)
  {
    face.resize(static_cast<std::size_t>(size) * size * 3);
  }
  const auto fillRow = [&](int face, int row)
  {
    float* texel = cube.Faces[face].data() + static_cast<std::size_t>(row) * size * 3;
    const double b = (2.0 * row + 1.0) / size - 1.0;
    for (int column = 0; column < size; ++column, texel += 3)
    {
      const double a = (2.0 * column + 1.0) / size - 1.0;
      const Color offset = Interpolate(grid, GetAngles(GetFaceDirection(face, a, b)));
      for (int channel = 0; channel < 3; ++channel)
      {
        texel[channel] = static_cast<float>(
          std::clamp(mean[channel] + offset[channel], range.Low[channel], range.High[channel]));
      }
    }
  };
  vtkSMPTools::For(0, 6 * size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        fillRow(static_cast<int>(i / size), static_cast<int>(i % size));
      }
    });
  return cube;
}
}

//------------------------------------------------------------------------------
CubeMap FilterDiffuse(const EnvironmentMap& map)
{
  // The integral of max(N.w, 0) over all directions is pi.
  return FilterSpecular(map, 1.0);
}

//------------------------------------------------------------------------------
CubeMap FilterSpecular(const EnvironmentMap& map, double power)
{
  const double lobe = power > 0.0 ? std::min(power, LargestFilteredPower) : 0.0;
  const std::vector<double> factors = ComputeLobeFactors(lobe);
  const Color mean = MeanRadiance(map);
  SphereGrid grid(GetNumberOfColumns(factors.size()));
  Deposit(map, mean, grid);
  Convolve(grid, factors);
  return MakeCubeMap(grid, mean, FindRange(map), GetFaceSize(lobe));
}

}
