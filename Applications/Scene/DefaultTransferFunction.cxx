#include "DefaultTransferFunction.h"

#include "VolumeBox.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr std::size_t NumberOfBins = 512;
// Voxels that are looked at, at most; they lie evenly in the volume.
constexpr vtkIdType LargestSample = 2000000;

using Histogram = std::array<double, NumberOfBins>;

Histogram CountValues(vtkDataArray* scalars, double lowest, double highest)
{
  Histogram histogram{};
  // Odd, so as not to hit the same few columns of a volume whose row is a power of two long.
  const vtkIdType stride = (scalars->GetNumberOfTuples() / LargestSample) | 1;
  for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); voxel += stride)
  {
    const double position =
      (scalars->GetComponent(voxel, 0) - lowest) / (highest - lowest) * NumberOfBins;
    if (position >= 0.0 && position <= NumberOfBins)
    {
      ++histogram[std::min(static_cast<std::size_t>(position), NumberOfBins - 1)];
    }
  }
  return histogram;
}

// Bin at whose upper edge the variance between the two classes is largest (Otsu 1979).
std::size_t FindThresholdBin(const Histogram& histogram)
{
  double count = 0.0;
  double sum = 0.0;
  for (std::size_t bin = 0; bin < NumberOfBins; ++bin)
  {
    count += histogram[bin];
    sum += histogram[bin] * static_cast<double>(bin);
  }
  std::size_t best = 0;
  double largestVariance = -1.0;
  double countBelow = 0.0;
  double sumBelow = 0.0;
  for (std::size_t bin = 0; bin + 1 < NumberOfBins; ++bin)
  {
    countBelow += histogram[bin];
    sumBelow += histogram[bin] * static_cast<double>(bin);
    const double countAbove = count - countBelow;
    if (countBelow > 0.0 && countAbove > 0.0)
    {
      const double apart = sumBelow / countBelow - (sum - sumBelow) / countAbove;
      const double variance = countBelow * countAbove * apart * apart;
      if (variance > largestVariance)
      {
        largestVariance = variance;
        best = bin;
      }
    }
  }
  return best;
}
}

//------------------------------------------------------------------------------
TransferFunctionDescription ChooseTransferFunction(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  double range[2];
  scalars->GetFiniteRange(range, 0);
  TransferFunctionDescription chosen;
  chosen.OpacityUnitDistance = MeanSpacing(image);
  const double width = range[1] - range[0];
  if (!(width > 0.0) || !std::isfinite(width))
  {
    chosen.Opacity = { { range[0], 0.1 } };
    chosen.Color = { { range[0], 0.95, 0.88, 0.76 } };
    return chosen;
  }
  const auto bin = FindThresholdBin(CountValues(scalars, range[0], range[1]));
  const double threshold = range[0] + width * static_cast<double>(bin + 1) / NumberOfBins;
  const auto above = [&](double part) { return threshold + part * (range[1] - threshold); };
  chosen.Opacity = { { threshold, 0.0 }, { above(0.25), 0.25 }, { range[1], 0.7 } };
  chosen.Color = { { threshold, 0.62, 0.30, 0.20 }, { above(0.2), 0.90, 0.68, 0.48 },
    { above(0.5), 0.97, 0.90, 0.78 }, { range[1], 1.0, 0.98, 0.94 } };
  return chosen;
}

}
