#include "SliceStack.h"

#include "NumberText.h"
#include "VolumeReadingError.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace penumbra
{

namespace
{

// Positions are often written in tenths of a millimetre. Slices that lie within this part of a gap
// of where they should be are taken to lie there.
constexpr double LocationTolerance = 0.05;

// Slices closer than this in mm are at one location whatever the others do.
constexpr double SmallestGap = 1e-4;

// For the same reason, slices shifted within their plane by less than this part of a pixel lie
// straight above each other.
constexpr double ShiftTolerance = 0.25;

// More would fill more of the volume by interpolation than was scanned.
constexpr std::size_t MostSlicesPerScanned = 4;

std::vector<double> GapsOf(const std::vector<PlacedSlice>& slices)
{
  std::vector<double> gaps;
  for (std::size_t index = 1; index < slices.size(); ++index)
  {
    gaps.push_back(slices[index].location - slices[index - 1].location);
  }
  return gaps;
}

double MedianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double LargestOf(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// The typical gap, of those that are gaps at all; 0 where there are none.
double TypicalGap(const std::vector<PlacedSlice>& slices)
{
  std::vector<double> gaps = GapsOf(slices);
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(), [](double gap) { return gap < SmallestGap; }),
    gaps.end());
  return gaps.empty() ? 0.0 : MedianOf(gaps);
}

Vector3 Difference(const Vector3& left, const Vector3& right)
{
  return { left[0] - right[0], left[1] - right[1], left[2] - right[2] };
}

double Dot(const Vector3& left, const Vector3& right)
{
  return vtkMath::Dot(left.data(), right.data());
}

// How far slices are shifted within their plane against the first one, in mm along row and column.
struct InPlaneShift
{
  std::vector<double> distances;
  std::array<std::vector<double>, 2> shifts;
};

InPlaneShift ShiftOf(const std::vector<PlacedSlice>& slices, const SliceOrientation& orientation)
{
  InPlaneShift shift;
  for (const PlacedSlice& slice : slices)
  {
    const Vector3 offset = Difference(slice.position, slices.front().position);
    shift.distances.push_back(Dot(offset, orientation.normal));
    shift.shifts[0].push_back(Dot(offset, orientation.row));
    shift.shifts[1].push_back(Dot(offset, orientation.column));
  }
  return shift;
}

// Least squares through the first slice.
double SlopeOf(const std::vector<double>& distances, const std::vector<double>& shifts)
{
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t index = 0; index < distances.size(); ++index)
  {
    products += distances[index] * shifts[index];
    squares += distances[index] * distances[index];
  }
  return squares > 0.0 ? products / squares : 0.0;
}

double LargestDeviation(
  const std::vector<double>& distances, const std::vector<double>& shifts, double slope)
{
  double largest = 0.0;
  for (std::size_t index = 0; index < distances.size(); ++index)
  {
    largest = std::max(largest, std::abs(shifts[index] - slope * distances[index]));
  }
  return largest;
}

// Every slice's place in units of `spacing`, if all are near to whole numbers.
bool AreMultiples(const std::vector<PlacedSlice>& slices, double spacing)
{
  for (const PlacedSlice& slice : slices)
  {
    const double place = (slice.location - slices.front().location) / spacing;
    if (std::abs(place - std::round(place)) > LocationTolerance)
    {
      return false;
    }
  }
  return true;
}

double RangeOf(const std::vector<PlacedSlice>& slices)
{
  return slices.back().location - slices.front().location;
}

// Places of the slices in even ones, the first of which is the first slice and the last the last.
EvenSlices MakeEven(const std::vector<PlacedSlice>& slices, std::size_t count)
{
  EvenSlices even;
  even.count = count;
  even.spacing = RangeOf(slices) / static_cast<double>(count - 1);
  for (const PlacedSlice& slice : slices)
  {
    const double place = (slice.location - slices.front().location) / even.spacing;
    const bool isNear = std::abs(place - std::round(place)) <= LocationTolerance;
    even.places.push_back(isNear ? std::round(place) : place);
  }
  return even;
}

void RefuseTooUneven(const std::vector<PlacedSlice>& slices, std::size_t count)
{
  if (count > MostSlicesPerScanned * slices.size())
  {
    const std::vector<double> gaps = GapsOf(slices);
    throw VolumeReadingError("its " + CountText(slices.size(), "slice") + " leave gaps of " +
      NumberText(*std::min_element(gaps.begin(), gaps.end())) + " to " +
      NumberText(LargestOf(gaps)) + " mm, too uneven for one volume");
  }
}

std::string MissingText(const std::vector<PlacedSlice>& slices, double spacing, std::size_t missing)
{
  constexpr std::size_t mostTold = 3;
  std::size_t holes = 0;
  std::string where;
  for (std::size_t index = 1; index < slices.size(); ++index)
  {
    const double gap = slices[index].location - slices[index - 1].location;
    if (gap < 1.5 * spacing)
    {
      continue;
    }
    if (++holes <= mostTold)
    {
      where += (where.empty() ? "" : ", ") + NumberText(gap) + " mm after slice " +
        std::to_string(index) + " of " + std::to_string(slices.size());
    }
  }
  return CountText(missing, "slice") + " missing in " + CountText(holes, "gap") + " (" + where +
    (holes > mostTold ? ", ..." : "") + ") of slices " + NumberText(spacing) +
    " mm apart; filled by interpolation";
}

}

void SortSlices(std::vector<PlacedSlice>& slices, const SliceOrientation& orientation,
  std::vector<std::string>& warnings)
{
  for (PlacedSlice& slice : slices)
  {
    slice.location = Dot(slice.position, orientation.normal);
  }
  const auto byLocation = [](const PlacedSlice& left, const PlacedSlice& right)
  { return std::tie(left.location, left.order) < std::tie(right.location, right.order); };
  std::stable_sort(slices.begin(), slices.end(), byLocation);

  const double tolerance = std::max(SmallestGap, LocationTolerance * TypicalGap(slices));
  std::vector<PlacedSlice> kept;
  std::size_t most = 1;
  std::size_t here = 0;
  for (const PlacedSlice& slice : slices)
  {
    if (kept.empty() || slice.location - kept.back().location > tolerance)
    {
      kept.push_back(slice);
      here = 1;
      continue;
    }
    most = std::max(most, ++here);
    if (slice.order < kept.back().order)
    {
      kept.back() = slice;
    }
  }
  if (kept.size() < slices.size())
  {
    warnings.push_back(CountText(slices.size() - kept.size(), "image") + " left out: up to " +
      std::to_string(most) + " at one of " + CountText(kept.size(), "position") +
      "; the first of each is taken, by temporal position, echo time, acquisition and instance");
  }
  slices = std::move(kept);
}

Vector3 FindStackingDirection(const std::vector<PlacedSlice>& slices,
  const SliceOrientation& orientation, std::vector<std::string>& warnings)
{
  const InPlaneShift shift = ShiftOf(slices, orientation);
  const std::array<double, 2> pixels{ orientation.columnSpacing, orientation.rowSpacing };
  std::array<double, 2> slopes{ 0.0, 0.0 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double tolerance = ShiftTolerance * pixels[axis];
    if (LargestDeviation(shift.distances, shift.shifts[axis], 0.0) <= tolerance)
    {
      continue;
    }
    slopes[axis] = SlopeOf(shift.distances, shift.shifts[axis]);
    const double deviation = LargestDeviation(shift.distances, shift.shifts[axis], slopes[axis]);
    if (deviation > tolerance)
    {
      throw VolumeReadingError("its slices are shifted irregularly against each other, by up to " +
        NumberText(deviation) + " mm along a " + (axis == 0 ? "row" : "column") +
        "; a straight stack is needed");
    }
  }
  Vector3 direction{};
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] = orientation.normal[axis] + slopes[0] * orientation.row[axis] +
      slopes[1] * orientation.column[axis];
  }
  const double tilt = std::hypot(slopes[0], slopes[1]);
  if (tilt > 0.0)
  {
    warnings.push_back("gantry tilt of " +
      NumberText(vtkMath::DegreesFromRadians(std::atan(tilt))) +
      " degrees: the slices stay where they are, by a sheared direction matrix");
  }
  return direction;
}

EvenSlices SpaceEvenly(const std::vector<PlacedSlice>& slices, std::vector<std::string>& warnings)
{
  const std::vector<double> gaps = GapsOf(slices);
  const double range = RangeOf(slices);
  const double mean = range / static_cast<double>(gaps.size());
  if (AreMultiples(slices, mean) && LargestOf(gaps) < 1.5 * mean)
  {
    return MakeEven(slices, slices.size());
  }
  const double smallest = *std::min_element(gaps.begin(), gaps.end());
  for (const double gap : { MedianOf(gaps), smallest })
  {
    const double steps = std::round(range / gap);
    if (AreMultiples(slices, range / steps))
    {
      const auto count = static_cast<std::size_t>(steps) + 1;
      RefuseTooUneven(slices, count);
      const EvenSlices even = MakeEven(slices, count);
      warnings.push_back(MissingText(slices, even.spacing, count - slices.size()));
      return even;
    }
  }
  const double finest = std::max(smallest, MedianOf(gaps) / MostSlicesPerScanned);
  const auto count = static_cast<std::size_t>(std::ceil(range / finest)) + 1;
  RefuseTooUneven(slices, count);
  const EvenSlices even = MakeEven(slices, count);
  warnings.push_back("uneven gaps of " + NumberText(smallest) + " to " +
    NumberText(LargestOf(gaps)) + " mm between " + CountText(slices.size(), "slice") +
    "; interpolated to " + std::to_string(count) + " slices " + NumberText(even.spacing) +
    " mm apart");
  return even;
}

}
