#include "DicomVolumePlan.h"

#include "NumberText.h"
#include "SliceStack.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace penumbra
{

namespace
{

// Unit vectors as written with few digits differ by less; over 500 pixels it is half a pixel.
constexpr double DirectionTolerance = 1e-3;

constexpr double SpacingTolerance = 1e-3;

// In mm. No detector is as fine or as coarse.
constexpr double SmallestSpacing = 1e-6;
constexpr double LargestSpacing = 1e4;

struct Slice
{
  DicomSource source;
  const DicomFile* file;
  const DicomFrame* frame;
};

std::vector<Slice> SlicesOf(const DicomSeries& series)
{
  std::vector<Slice> slices;
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
bool AreAlike(const Slice& left, const Slice& right)
{
  const DicomImage& a = left.file->image;
  const DicomImage& b = right.file->image;
  return a.columns == b.columns && a.rows == b.rows && a.isInverted == b.isInverted &&
    a.frameOfReferenceUID == b.frameOfReferenceUID &&
    left.frame->position.has_value() == right.frame->position.has_value() &&
    AreNear(left.frame->orientation, right.frame->orientation, DirectionTolerance) &&
    AreNear(left.frame->pixelSpacing, right.frame->pixelSpacing, SpacingTolerance);
}

std::string SizeText(const Slice& slice)
{
  return std::to_string(slice.file->image.columns) + "x" + std::to_string(slice.file->image.rows);
}

// The largest group of slices that are alike.
std::vector<Slice> TakeMostAlike(const std::vector<Slice>& all, std::vector<std::string>& warnings)
{
  std::vector<std::vector<Slice>> groups;
  for (const Slice& slice : all)
  {
    const auto group = std::find_if(groups.begin(), groups.end(),
      [&slice](const std::vector<Slice>& of) { return AreAlike(of.front(), slice); });
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

std::optional<double> UsableSpacing(double spacing)
{
  const bool isUsable = spacing >= SmallestSpacing && spacing <= LargestSpacing;
  return isUsable ? std::optional<double>(spacing) : std::nullopt;
}

void SetPixelSpacing(
  const Slice& slice, SliceOrientation& orientation, std::vector<std::string>& warnings)
{
  const auto& spacing = slice.frame->pixelSpacing;
  const auto rows = spacing ? UsableSpacing((*spacing)[0]) : std::nullopt;
  const auto columns = spacing ? UsableSpacing((*spacing)[1]) : std::nullopt;
  if (!rows || !columns)
  {
    warnings.push_back("the pixel spacing is " +
      (spacing ? NumberText((*spacing)[0]) + " and " + NumberText((*spacing)[1]) + " mm"
               : std::string("not given")) +
      "; 1 mm is taken");
    return;
  }
  if (slice.frame->isSpacingAtDetector)
  {
    warnings.push_back("the pixel spacing of " + NumberText(*rows) + " and " +
      NumberText(*columns) + " mm is that of the detector; the body is smaller");
  }
  orientation.rowSpacing = *rows;
  orientation.columnSpacing = *columns;
}

SliceOrientation OrientationOf(const Slice& slice, std::vector<std::string>& warnings)
{
  const std::array<double, 6> axial{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
  const auto& given = slice.frame->orientation;
  if (!given && slice.frame->position)
  {
    warnings.push_back("the images have no orientation; axial slices are assumed");
  }
  const std::array<double, 6> directions = given.value_or(axial);
  SliceOrientation orientation;
  std::copy_n(directions.begin(), 3, orientation.row.begin());
  std::copy_n(directions.begin() + 3, 3, orientation.column.begin());
  const double rowLength = vtkMath::Normalize(orientation.row.data());
  const double columnLength = vtkMath::Normalize(orientation.column.data());
  const double cosine = vtkMath::Dot(orientation.row.data(), orientation.column.data());
  // Written so that NaN fails as well.
  if (!(std::abs(rowLength - 1.0) < 0.01 && std::abs(columnLength - 1.0) < 0.01 &&
        std::abs(cosine) < 0.01))
  {
    std::string text;
    for (const double value : directions)
    {
      text += (text.empty() ? "" : " ") + NumberText(value);
    }
    throw VolumeReadingError(
      "its Image Orientation (Patient) is " + text + "; two perpendicular unit vectors are needed");
  }
  vtkMath::Cross(orientation.row.data(), orientation.column.data(), orientation.normal.data());
  vtkMath::Normalize(orientation.normal.data());
  vtkMath::Cross(orientation.normal.data(), orientation.row.data(), orientation.column.data());
  SetPixelSpacing(slice, orientation, warnings);
  return orientation;
}

struct SliceDistance
{
  double millimetres = 1.0;
  std::string origin = "a guess";
};

// The distance between slices as far as one slice tells it.
SliceDistance DistanceOf(const Slice& slice, const SliceOrientation& orientation)
{
  const auto usable = [](const std::optional<double>& value)
  { return value ? UsableSpacing(std::abs(*value)) : std::nullopt; };
  if (const auto spacing = usable(slice.frame->spacingBetweenSlices))
  {
    return { *spacing, "Spacing Between Slices" };
  }
  if (const auto thickness = usable(slice.frame->sliceThickness))
  {
    return { *thickness, "Slice Thickness" };
  }
  return { orientation.rowSpacing, "the distance of rows" };
}

std::vector<PlacedSlice> PlaceByPosition(const std::vector<Slice>& slices)
{
  std::vector<PlacedSlice> placed;
  for (const Slice& slice : slices)
  {
    placed.push_back({ slice.source, *slice.frame->position, slice.frame->order, 0.0 });
  }
  return placed;
}

std::vector<PlacedSlice> PlaceByNumber(std::vector<Slice> slices,
  const SliceOrientation& orientation, std::vector<std::string>& warnings)
{
  std::stable_sort(slices.begin(), slices.end(),
    [](const Slice& left, const Slice& right) { return left.frame->order < right.frame->order; });
  const SliceDistance distance = DistanceOf(slices.front(), orientation);
  warnings.push_back("the images have no positions; " + CountText(slices.size(), "slice") +
    " stacked by instance number, " + NumberText(distance.millimetres) + " mm apart (" +
    distance.origin + ")");
  std::vector<PlacedSlice> placed;
  for (const Slice& slice : slices)
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
  const std::vector<Slice> alike = TakeMostAlike(SlicesOf(series), warnings);
  const Slice& first = alike.front();
  const SliceOrientation orientation = OrientationOf(first, warnings);
  std::vector<PlacedSlice> placed =
    first.frame->position ? PlaceByPosition(alike) : PlaceByNumber(alike, orientation, warnings);
  SortSlices(placed, orientation, warnings);

  EvenSlices even{ DistanceOf(first, orientation).millimetres, 1, { 0.0 } };
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
