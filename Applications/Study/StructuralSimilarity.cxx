#include "StructuralSimilarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace penumbra
{
namespace
{
constexpr int reach = 5;
using Weights = std::array<double, 2 * reach + 1>;

Weights GaussianWeights()
{
  constexpr double deviation = 1.5;
  Weights weights;
  for (int offset = -reach; offset <= reach; ++offset)
  {
    weights[offset + reach] = std::exp(-offset * offset / (2 * deviation * deviation));
  }
  return weights;
}

/// The weighted mean over the window about position, along one line of the picture.
double LineMean(const double* line, int position, int length, int stride, const Weights& weights)
{
  double sum = 0.0;
  double total = 0.0;
  const int last = std::min(position + reach, length - 1);
  for (int at = std::max(position - reach, 0); at <= last; ++at)
  {
    const double weight = weights[at - position + reach];
    sum += weight * line[static_cast<std::size_t>(at) * stride];
    total += weight;
  }
  return sum / total;
}

GreyPicture WindowMeans(const GreyPicture& picture)
{
  static const Weights weights = GaussianWeights();
  GreyPicture alongRows = picture;
  GreyPicture means = picture;
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      const std::size_t row = static_cast<std::size_t>(y) * picture.width;
      alongRows.levels[row + x] =
        LineMean(picture.levels.data() + row, x, picture.width, 1, weights);
    }
  }
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      means.levels[static_cast<std::size_t>(y) * picture.width + x] =
        LineMean(alongRows.levels.data() + x, y, picture.height, picture.width, weights);
    }
  }
  return means;
}

GreyPicture MeansOfProduct(const GreyPicture& a, const GreyPicture& b)
{
  GreyPicture product = a;
  std::transform(a.levels.begin(), a.levels.end(), b.levels.begin(), product.levels.begin(),
    std::multiplies<double>());
  return WindowMeans(product);
}
}

double StructuralSimilarity(const GreyPicture& a, const GreyPicture& b)
{
  constexpr double c1 = 0.01 * 255 * 0.01 * 255;
  constexpr double c2 = 0.03 * 255 * 0.03 * 255;
  const GreyPicture meansA = WindowMeans(a);
  const GreyPicture meansB = WindowMeans(b);
  const GreyPicture meansAA = MeansOfProduct(a, a);
  const GreyPicture meansBB = MeansOfProduct(b, b);
  const GreyPicture meansAB = MeansOfProduct(a, b);

  double sum = 0.0;
  for (std::size_t i = 0; i < a.levels.size(); ++i)
  {
    const double meanA = meansA.levels[i];
    const double meanB = meansB.levels[i];
    const double varianceA = meansAA.levels[i] - meanA * meanA;
    const double varianceB = meansBB.levels[i] - meanB * meanB;
    const double covariance = meansAB.levels[i] - meanA * meanB;
    sum += (2 * meanA * meanB + c1) * (2 * covariance + c2) /
      ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
  }
  return sum / a.levels.size();
}
}
