#include "Preset.h"

#include "VolumeBox.h"
#include "VolumeFields.h"

#include <vtkImageData.h>

#include <cmath>

namespace penumbra
{
namespace
{
// Hounsfield units: air is -1000, and metal and the range of scanners end below 32768.
constexpr double HighestAir = -500.0;
constexpr double LowestBone = 200.0;
constexpr double HighestHounsfield = 32767.0;
constexpr double SoftTissue = -300.0;

// Of a CT, the least part of the body that is bone for it to be worth showing.
constexpr double LeastBone = 0.02;

// Values whose variance two kinds explain to a smaller part have no surface.
constexpr double LeastSeparability = 0.5;

// A preset's unit distance is in this part of the volume's diagonal.
constexpr double UnitsPerDiagonal = 400.0;

PresetChoice ChooseForCT(const VolumeStatistics& statistics, const std::string& reason)
{
  const double body = statistics.GetPartAbove(SoftTissue);
  const bool hasBone = statistics.GetPartAbove(LowestBone) > LeastBone * body;
  return hasBone ? PresetChoice{ "ct-bone", reason + ", and there is bone" }
                 : PresetChoice{ "ct-skin", reason + ", and there is hardly any bone" };
}

double ScaleValue(double x, PresetScale scale, const VolumeStatistics& statistics)
{
  const double threshold = statistics.GetThreshold();
  switch (scale)
  {
    case PresetScale::Percentiles:
      return statistics.GetPercentile(x, threshold);
    case PresetScale::AllPercentiles:
      return statistics.GetPercentile(x, statistics.GetLowest());
    case PresetScale::Threshold:
    {
      // A few voxels far above all others would flatten the rest.
      const double highest = statistics.GetPercentile(99.9, threshold);
      const double end = x >= 0.0 ? highest : statistics.GetLowest();
      return threshold + std::abs(x) * (end - threshold);
    }
    default:
      return x;
  }
}

template <typename Points>
Points ScalePoints(Points points, PresetScale scale, const VolumeStatistics& statistics)
{
  for (auto& point : points)
  {
    point[0] = ScaleValue(point[0], scale, statistics);
  }
  return points;
}
}

//------------------------------------------------------------------------------
PresetChoice ChoosePreset(vtkImageData* image, const VolumeStatistics& statistics)
{
  const std::string modality = TextField(image, "Modality");
  if (modality == "CT" || TextField(image, "Units") == "HU")
  {
    return ChooseForCT(statistics, "the file says that it is a CT");
  }
  if (modality == "MR")
  {
    return { "mr-head", "the file says that it is an MR" };
  }
  const bool looksHounsfield = statistics.GetLowest() <= HighestAir &&
    statistics.GetLowest() >= -HighestHounsfield && statistics.GetHighest() > LowestBone &&
    statistics.GetHighest() <= HighestHounsfield;
  if (modality.empty() && looksHounsfield)
  {
    return ChooseForCT(statistics, "the values have the range of a CT's");
  }
  if (statistics.GetSeparability() >= LeastSeparability)
  {
    return { "surface", "the values fall into two kinds" };
  }
  return { "cloud", "the values do not fall into two kinds" };
}

//------------------------------------------------------------------------------
TransferFunctionDescription ScaleToVolume(
  const Preset& preset, vtkImageData* image, const VolumeStatistics& statistics)
{
  TransferFunctionDescription function = preset.TransferFunction;
  if (!statistics.HasRange())
  {
    function.Opacity = { { statistics.GetLowest(), 0.1 } };
    function.Color = { { statistics.GetLowest(), 0.95, 0.88, 0.76 } };
  }
  else
  {
    function.Opacity = ScalePoints(*function.Opacity, preset.Scale, statistics);
    function.Color = ScalePoints(*function.Color, preset.Scale, statistics);
  }
  if (preset.Scale != PresetScale::Scalars)
  {
    const std::array<double, 16> identity{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    const auto corners = VolumeBox(image, identity).GetCorners();
    const double diagonal = Length(Difference(corners.back(), corners.front()));
    function.OpacityUnitDistance =
      function.OpacityUnitDistance.value_or(1.0) * diagonal / UnitsPerDiagonal;
  }
  return function;
}

}
