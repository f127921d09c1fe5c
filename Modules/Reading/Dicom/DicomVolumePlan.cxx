#include "DicomVolumePlan.h"

#include "AlikeSlices.h"
#include "NumberText.h"
#include "SliceOrientation.h"
#include "SliceStack.h"
#include "vtkMath.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace penumbra
{

namespace
{

std::vector<PlacedSlice> PlaceByPosition(const std::vector<ScannedSlice>& slices)
{
  std::vector<PlacedSlice> placed;
  for (const ScannedSlice& slice : slices)
  {
    placed.push_back({ slice.source, *slice.frame->position, slice.frame->order, 0.0 });
  }
  return placed;
}

std::vector<PlacedSlice> PlaceByNumber(std::vector<ScannedSlice> slices,
  const SliceOrientation& orientation, std::vector<std::string>& warnings)
{
  std::stable_sort(slices.begin(), slices.end(),
    [](const ScannedSlice& left, const ScannedSlice& right)
    { return left.frame->order < right.frame->order; });
  const SliceDistance distance = DistanceOf(*slices.front().frame, orientation);
  warnings.push_back("the images have no positions; " + CountText(slices.size(), "slice") +
    " stacked by instance number, " + NumberText(distance.millimetres) + " mm apart (" +
    distance.origin + ")");
  std::vector<PlacedSlice> placed;
  for (const ScannedSlice& slice : slices)
  {
    const double place = distance.millimetres * static_cast<double>(placed.size());
    const Vector3& normal = orientation.normal;
    placed.push_back({ slice.source, { place * normal[0], place * normal[1], place * normal[2] },
      slice.frame->order, 0.0 });
  }
  return placed;
}

void TellMixedRescale(const DicomSeries& series, const std::vector<PlacedSlice>& slices,
  std::vector<std::string>& warnings)
{
  const auto rescaleOf = [&series](const PlacedSlice& slice)
  { return series.files[slice.source.file].image.frames[slice.source.frame].rescale; };
  std::vector<double> slopes;
  std::vector<double> intercepts;
  for (const PlacedSlice& slice : slices)
  {
    slopes.push_back(rescaleOf(slice).slope);
    intercepts.push_back(rescaleOf(slice).intercept);
  }
  const auto [lowestSlope, highestSlope] = std::minmax_element(slopes.begin(), slopes.end());
  const auto [lowest, highest] = std::minmax_element(intercepts.begin(), intercepts.end());
  if (*lowestSlope != *highestSlope || *lowest != *highest)
  {
    warnings.push_back("mixed rescale, applied slice by slice: slopes " + NumberText(*lowestSlope) +
      " to " + NumberText(*highestSlope) + ", intercepts " + NumberText(*lowest) + " to " +
      NumberText(*highest));
  }
}

void TellMixedFormats(const DicomSeries& series, const std::vector<PlacedSlice>& slices,
  std::vector<std::string>& warnings)
{
  const auto formatOf = [&series](const PlacedSlice& slice)
  { return series.files[slice.source.file].image.pixel; };
  const auto others = std::count_if(slices.begin(), slices.end(),
    [&](const PlacedSlice& slice) { return !(formatOf(slice) == formatOf(slices.front())); });
  if (others > 0)
  {
    warnings.push_back(CountText(static_cast<std::size_t>(others), "slice") +
      " stored with other bits than the first");
  }
}

void TellInversion(const DicomImage& image, std::vector<std::string>& warnings)
{
  if (image.isInverted)
  {
    warnings.push_back(std::string("MONOCHROME1: small values are shown bright; the values are ") +
      (image.isTurnedOver ? "turned over" : "kept, for they have a unit"));
  }
}

// Each slice of the volume from the one or two sources, in order of their places, that enclose it.
std::vector<DicomVolumeSlice> SlicesThrough(
  const std::vector<DicomSource>& sources, std::size_t count)
{
  std::vector<DicomVolumeSlice> slices;
  std::size_t below = 0;
  for (std::size_t slice = 0; slice < count; ++slice)
  {
    const auto place = static_cast<double>(slice);
    while (below + 1 < sources.size() && sources[below + 1].place <= place)
    {
      ++below;
    }
    const double start = sources[below].place;
    if (place <= start || below + 1 == sources.size())
    {
      slices.push_back({ below, below, 0.0 });
      continue;
    }
    const double weight = (place - start) / (sources[below + 1].place - start);
    slices.push_back({ below, below + 1, weight });
  }
  return slices;
}

void SetGeometry(DicomVolumePlan& plan, const DicomImage& image,
  const SliceOrientation& orientation, const Vector3& origin, Vector3 stacking, double spacing)
{
  const double length = vtkMath::Normalize(stacking.data());
  VolumeGeometry& geometry = plan.geometry;
  geometry.dimensions = { image.columns, image.rows,
    static_cast<std::int64_t>(plan.slices.size()) };
  geometry.spacing = { orientation.columnSpacing, orientation.rowSpacing, spacing * length };
  geometry.origin = origin;
  for (int row = 0; row < 3; ++row)
  {
    geometry.direction[3 * row] = orientation.row[row];
    geometry.direction[3 * row + 1] = orientation.column[row];
    geometry.direction[3 * row + 2] = stacking[row];
  }
  CheckGeometry(geometry);
}

}

DicomVolumePlan PlanVolume(const DicomSeries& series, std::vector<std::string>& warnings)
{
  const std::vector<ScannedSlice> alike = TakeAlikeSlices(series, warnings);
  const ScannedSlice& first = alike.front();
  const SliceOrientation orientation = OrientationOf(*first.frame, warnings);
  std::vector<PlacedSlice> placed =
    first.frame->position ? PlaceByPosition(alike) : PlaceByNumber(alike, orientation, warnings);
  SortSlices(placed, orientation, warnings);

  EvenSlices even{ DistanceOf(*first.frame, orientation).millimetres, 1, { 0.0 } };
  Vector3 stacking = orientation.normal;
  if (placed.size() > 1)
  {
    stacking = FindStackingDirection(placed, orientation, warnings);
    even = SpaceEvenly(placed, warnings);
  }
  DicomVolumePlan plan;
  for (std::size_t index = 0; index < placed.size(); ++index)
  {
    plan.sources.push_back(placed[index].source);
    plan.sources.back().place = even.places[index];
  }
  plan.slices = SlicesThrough(plan.sources, even.count);
  SetGeometry(
    plan, first.file->image, orientation, placed.front().position, stacking, even.spacing);
  TellMixedRescale(series, placed, warnings);
  TellMixedFormats(series, placed, warnings);
  TellInversion(first.file->image, warnings);
  return plan;
}

bool LeaveOutFile(DicomVolumePlan& plan, std::size_t file)
{
  std::vector<DicomSource> remaining;
  std::copy_if(plan.sources.begin(), plan.sources.end(), std::back_inserter(remaining),
    [file](const DicomSource& source) { return source.file != file; });
  if (2 * remaining.size() < plan.slices.size())
  {
    return false;
  }
  plan.sources = std::move(remaining);
  plan.slices = SlicesThrough(plan.sources, plan.slices.size());
  return true;
}

}
