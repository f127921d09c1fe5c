#include "AlikeSlices.h"

#include "NumberText.h"
#include "VolumeReadingError.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace penumbra
{

namespace
{

// Unit vectors as written with few digits differ by less; over 500 pixels it is half a pixel.
constexpr double DirectionTolerance = 1e-3;

constexpr double SpacingTolerance = 1e-3;

std::vector<ScannedSlice> SlicesOf(const DicomSeries& series)
{
  std::vector<ScannedSlice> slices;
  for (std::size_t file = 0; file < series.files.size(); ++file)
  {
    const DicomFile& of = series.files[file];
    for (std::size_t frame = 0; frame < of.image.frames.size(); ++frame)
    {
      slices.push_back({ { file, frame, 0.0 }, &of, &of.image.frames[frame] });
    }
  }
  return slices;
}

template <std::size_t Count>
bool AreNear(const std::optional<std::array<double, Count>>& left,
  const std::optional<std::array<double, Count>>& right, double tolerance)
{
  if (!left || !right)
  {
    return !left && !right;
  }
  return std::equal(left->begin(), left->end(), right->begin(),
    [tolerance](double a, double b)
    { return std::abs(a - b) <= tolerance * std::max(1.0, std::abs(a)); });
}

// Whether two slices can be of one volume.
bool AreAlike(const ScannedSlice& left, const ScannedSlice& right)
{
  const DicomImage& a = left.file->image;
  const DicomImage& b = right.file->image;
  return a.columns == b.columns && a.rows == b.rows && a.isInverted == b.isInverted &&
    a.frameOfReferenceUID == b.frameOfReferenceUID &&
    left.frame->position.has_value() == right.frame->position.has_value() &&
    AreNear(left.frame->orientation, right.frame->orientation, DirectionTolerance) &&
    AreNear(left.frame->pixelSpacing, right.frame->pixelSpacing, SpacingTolerance);
}

std::string SizeText(const ScannedSlice& slice)
{
  return std::to_string(slice.file->image.columns) + "x" + std::to_string(slice.file->image.rows);
}

}

std::vector<ScannedSlice> TakeAlikeSlices(
  const DicomSeries& series, std::vector<std::string>& warnings)
{
  const std::vector<ScannedSlice> all = SlicesOf(series);
  std::vector<std::vector<ScannedSlice>> groups;
  for (const ScannedSlice& slice : all)
  {
    const auto group = std::find_if(groups.begin(), groups.end(),
      [&slice](const std::vector<ScannedSlice>& of) { return AreAlike(of.front(), slice); });
    if (group == groups.end())
    {
      groups.push_back({ slice });
    }
    else
    {
      group->push_back(slice);
    }
  }
  const auto largest = std::max_element(groups.begin(), groups.end(),
    [](const auto& left, const auto& right) { return left.size() < right.size(); });
  if (groups.size() > 1)
  {
    if (largest->size() == 1)
    {
      throw VolumeReadingError("no two of its " + CountText(all.size(), "image") +
        " agree in size, orientation, pixel spacing and kind");
    }
    warnings.push_back(CountText(all.size() - largest->size(), "image") +
      " left out, of another size, orientation, pixel spacing, frame of reference or "
      "kind than the " +
      CountText(largest->size(), "image") + " of " + SizeText(largest->front()) + " taken");
  }
  return *largest;
}

}
