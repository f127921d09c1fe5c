#include "VolumeStatistics.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
constexpr vtkIdType LargestSample = 2000000;
}

//------------------------------------------------------------------------------
VolumeStatistics::VolumeStatistics(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->GetFiniteRange(this->Range.data(), 0);
  this->Threshold = this->GetLowest();
  if (!this->HasRange())
  {
    return;
  }
  const double width = this->GetHighest() - this->GetLowest();
  // Odd, so as not to hit the same few columns of a volume whose row is a power of two long.
  const vtkIdType stride = (scalars->GetNumberOfTuples() / LargestSample) | 1;
  for (vtkIdType voxel = 0; voxel < scalars->GetNumberOfTuples(); voxel += stride)
  {
    const double position =
      (scalars->GetComponent(voxel, 0) - this->GetLowest()) / width * NumberOfBins;
    if (position >= 0.0 && position <= NumberOfBins)
    {
      ++this->Histogram[std::min(static_cast<std::size_t>(position), NumberOfBins - 1)];
    }
  }
  this->FindThreshold();
}

//------------------------------------------------------------------------------
bool VolumeStatistics::HasRange() const
{
  const double width = this->GetHighest() - this->GetLowest();
  return width > 0.0 && std::isfinite(width);
}

//------------------------------------------------------------------------------
double VolumeStatistics::UpperEdge(std::size_t bin) const
{
  return this->GetLowest() +
    (this->GetHighest() - this->GetLowest()) * static_cast<double>(bin + 1) / NumberOfBins;
}

//------------------------------------------------------------------------------
void VolumeStatistics::FindThreshold()
{
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t bin = 0; bin < NumberOfBins; ++bin)
  {
    const auto place = static_cast<double>(bin);
    count += this->Histogram[bin];
    sum += this->Histogram[bin] * place;
    squares += this->Histogram[bin] * place * place;
  }
  double countBelow = 0.0;
  double sumBelow = 0.0;
  double largest = -1.0;
  for (std::size_t bin = 0; bin + 1 < NumberOfBins; ++bin)
  {
    countBelow += this->Histogram[bin];
    sumBelow += this->Histogram[bin] * static_cast<double>(bin);
    const double countAbove = count - countBelow;
    if (countBelow > 0.0 && countAbove > 0.0)
    {
      const double apart = sumBelow / countBelow - (sum - sumBelow) / countAbove;
      const double between = countBelow * countAbove * apart * apart;
      if (between > largest)
      {
        largest = between;
        this->Threshold = this->UpperEdge(bin);
      }
    }
  }
  const double all = count * squares - sum * sum;
  this->Separability = all > 0.0 ? std::max(largest, 0.0) / all : 0.0;
}

//------------------------------------------------------------------------------
double VolumeStatistics::GetPartAbove(double value) const
{
  double above = 0.0;
  double count = 0.0;
  for (std::size_t bin = 0; bin < NumberOfBins; ++bin)
  {
    count += this->Histogram[bin];
    above += this->UpperEdge(bin) > value ? this->Histogram[bin] : 0.0;
  }
  return count > 0.0 ? above / count : 0.0;
}

//------------------------------------------------------------------------------
double VolumeStatistics::GetPercentile(double percent, double lowest) const
{
  double count = 0.0;
  for (std::size_t bin = 0; bin < NumberOfBins; ++bin)
  {
    count += this->UpperEdge(bin) > lowest ? this->Histogram[bin] : 0.0;
  }
  const double wanted = count * percent / 100.0;
  double below = 0.0;
  double edge = lowest;
  for (std::size_t bin = 0; bin < NumberOfBins; ++bin)
  {
    if (this->UpperEdge(bin) <= lowest || this->Histogram[bin] == 0.0)
    {
      continue;
    }
    if (below + this->Histogram[bin] >= wanted)
    {
      const double part = (wanted - below) / this->Histogram[bin];
      const double start = std::max(edge, bin > 0 ? this->UpperEdge(bin - 1) : this->GetLowest());
      return start + part * (this->UpperEdge(bin) - start);
    }
    below += this->Histogram[bin];
    edge = this->UpperEdge(bin);
  }
  return this->GetHighest();
}

}
