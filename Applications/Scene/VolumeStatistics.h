/**
 * @class   VolumeStatistics
 * @brief   how a volume's values are distributed
 */

#ifndef VolumeStatistics_h
#define VolumeStatistics_h

#include <array>
#include <cstddef>

class vtkImageData;

namespace penumbra
{

class VolumeStatistics
{
public:
  /// Of the finite values; of a large volume, of an even sample of them.
  explicit VolumeStatistics(vtkImageData* image);

  double GetLowest() const { return this->Range[0]; }
  double GetHighest() const { return this->Range[1]; }

  /// Whether there is more than one value.
  bool HasRange() const;

  /// The value between background and object: where the variance between the values below and above
  /// is largest (Otsu 1979).
  double GetThreshold() const { return this->Threshold; }

  /// How well the threshold tells two kinds of values apart, 0 to 1: the variance between both over
  /// all variance.
  double GetSeparability() const { return this->Separability; }

  /// The value below which `percent` of the values above `lowest` lie, 0 to 100.
  double GetPercentile(double percent, double lowest) const;

  /// Part of all values that are above `value`, 0 to 1.
  double GetPartAbove(double value) const;

private:
  static constexpr std::size_t NumberOfBins = 4096;

  double UpperEdge(std::size_t bin) const;
  void FindThreshold();

  std::array<double, 2> Range{ 0.0, 0.0 };
  std::array<double, NumberOfBins> Histogram{};
  double Threshold = 0.0;
  double Separability = 0.0;
};

}

#endif
