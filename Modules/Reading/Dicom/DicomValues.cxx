#include "DicomValues.h"

#include "vtkType.h"

#include <algorithm>
#include <limits>
#include <set>

namespace penumbra
{

namespace
{

struct ScalarRange
{
  int type;
  double lowest;
  double highest;
};

template <typename Scalar>
ScalarRange RangeOf(int type)
{
  return { type, static_cast<double>(std::numeric_limits<Scalar>::lowest()),
    static_cast<double>(std::numeric_limits<Scalar>::max()) };
}

// The smallest type that holds what is possible, or where that is more than 16 bits, first those
// that hold what is likely; then wider ones, for voxels without a measurement need a value too.
std::vector<int> IntegerTypes(const DicomValues& values)
{
  const ScalarRange all[] = { RangeOf<std::uint8_t>(VTK_UNSIGNED_CHAR),
    RangeOf<std::int8_t>(VTK_SIGNED_CHAR), RangeOf<std::int16_t>(VTK_SHORT),
    RangeOf<std::uint16_t>(VTK_UNSIGNED_SHORT), RangeOf<std::int32_t>(VTK_INT),
    RangeOf<std::uint32_t>(VTK_UNSIGNED_INT) };
  const auto smallest = std::find_if(std::begin(all), std::end(all),
    [&values](const ScalarRange& type)
    { return type.lowest <= values.possible[0] && values.possible[1] <= type.highest; });
  const bool isLong = smallest == std::end(all) || smallest - std::begin(all) >= 4;
  std::vector<int> types;
  if (isLong && values.mostBitsAllocated <= 16)
  {
    types = { VTK_SHORT, VTK_UNSIGNED_SHORT };
  }
  if (smallest != std::end(all))
  {
    types.push_back(smallest->type);
  }
  if (!isLong)
  {
    types.push_back(VTK_INT);
  }
  types.push_back(VTK_DOUBLE);
  return types;
}

}

DicomValues SummarizeValues(const std::vector<DicomImageFrame>& slices)
{
  DicomValues values;
  values.possible = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  std::set<double> paddings;
  for (const auto& [image, frame] : slices)
  {
    const DicomRescale& rescale = image->frames[frame].rescale;
    const auto value = [&rescale](std::int64_t stored)
    { return rescale.slope * static_cast<double>(stored) + rescale.intercept; };
    for (const double extreme :
      { value(image->pixel.LowestStored()), value(image->pixel.HighestStored()) })
    {
      values.possible[0] = std::min(values.possible[0], extreme);
      values.possible[1] = std::max(values.possible[1], extreme);
    }
    values.areWhole = values.areWhole && rescale.IsWhole();
    values.mostBitsStored = std::max(values.mostBitsStored, image->pixel.bitsStored);
    values.mostBitsAllocated = std::max(values.mostBitsAllocated, image->pixel.bitsAllocated);
    if (image->padding)
    {
      paddings.insert(value((*image->padding)[0]));
    }
  }
  values.hasPadding = !paddings.empty();
  if (paddings.size() == 1)
  {
    values.padding = *paddings.begin();
  }
  return values;
}

std::vector<int> PossibleScalarTypes(const DicomValues& values)
{
  const bool isPaddingOne = !values.hasPadding || values.padding;
  if (!values.areWhole || !isPaddingOne)
  {
    return { values.mostBitsStored > 24 ? VTK_DOUBLE : VTK_FLOAT };
  }
  return IntegerTypes(values);
}

}
