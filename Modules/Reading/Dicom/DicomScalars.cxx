#include "DicomScalars.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace penumbra
{

namespace
{

// Padding that lies further below all other values, in parts of their range, would stretch it.
constexpr double FarBelow = 0.05;

template <typename Stored>
Stored StoredAt(const char* bytes, std::size_t index)
{
  Stored value;
  std::memcpy(&value, bytes + index * sizeof(Stored), sizeof(Stored));
  return value;
}

template <typename Scalar>
struct Converted
{
  Scalar value;
  bool isHeld;
};

template <typename Scalar>
Converted<Scalar> ToScalar(double value)
{
  if constexpr (std::is_floating_point_v<Scalar>)
  {
    return { static_cast<Scalar>(value), true };
  }
  else
  {
    const bool isHeld = value >= static_cast<double>(std::numeric_limits<Scalar>::lowest()) &&
      value <= static_cast<double>(std::numeric_limits<Scalar>::max());
    return { isHeld ? static_cast<Scalar>(value) : Scalar(0), isHeld };
  }
}

// How the bits of a pixel become a modality value: those that are stored, as a number, turned over
// or not, rescaled.
class StoredToValue
{
public:
  StoredToValue(const DicomPixelFormat& pixel, const DicomImage& image, const DicomRescale& rescale)
    : Shift(pixel.highBit + 1 - pixel.bitsStored)
    , Mask((std::uint64_t(1) << pixel.bitsStored) - 1)
    , Sign(pixel.isSigned ? std::uint64_t(1) << (pixel.bitsStored - 1) : 0)
    , IsTurned(image.isTurnedOver)
    , Sum(pixel.LowestStored() + pixel.HighestStored())
    , Rescale(rescale)
    , Padding(image.padding)
  {
  }

  std::int64_t ToStored(std::uint64_t bits) const
  {
    const std::uint64_t value = (bits >> this->Shift) & this->Mask;
    return static_cast<std::int64_t>(value ^ this->Sign) - static_cast<std::int64_t>(this->Sign);
  }

  bool IsPadding(std::int64_t stored) const
  {
    return this->Padding && stored >= (*this->Padding)[0] && stored <= (*this->Padding)[1];
  }

  double ToValue(std::int64_t stored) const
  {
    const auto shown = static_cast<double>(this->IsTurned ? this->Sum - stored : stored);
    return this->Rescale.slope * shown + this->Rescale.intercept;
  }

private:
  int Shift;
  std::uint64_t Mask;
  std::uint64_t Sign;
  bool IsTurned;
  std::int64_t Sum;
  DicomRescale Rescale;
  std::optional<std::array<std::int64_t, 2>> Padding;
};

template <typename Pixel, typename Scalar>
DicomConversion ConvertAll(const char* bytes, std::size_t count, const StoredToValue& convert,
  const std::optional<Scalar>& marker, Scalar* values)
{
  DicomConversion result;
  for (std::size_t index = 0; index < count; ++index)
  {
    const std::int64_t stored = convert.ToStored(StoredAt<Pixel>(bytes, index));
    if (convert.IsPadding(stored))
    {
      values[index] = *marker;
      result.hasPadding = true;
      continue;
    }
    const Converted<Scalar> converted = ToScalar<Scalar>(convert.ToValue(stored));
    values[index] = converted.value;
    result.isHeld = result.isHeld && converted.isHeld && !(marker && converted.value == *marker);
  }
  return result;
}

// A slope and an intercept of whole numbers, turned over or not, and the values that they lead to.
struct WholeRescale
{
  std::int64_t slope;
  std::int64_t intercept;

  std::int64_t operator()(std::int64_t stored) const
  {
    return this->slope * stored + this->intercept;
  }
};

// Nothing where slope or intercept are not whole, or so large that integers overflow.
std::optional<WholeRescale> ToWhole(
  const DicomPixelFormat& pixel, const DicomImage& image, const DicomRescale& rescale)
{
  if (!rescale.IsWhole())
  {
    return std::nullopt;
  }
  WholeRescale whole{ static_cast<std::int64_t>(rescale.slope),
    static_cast<std::int64_t>(rescale.intercept) };
  if (image.isTurnedOver)
  {
    whole.intercept += whole.slope * (pixel.LowestStored() + pixel.HighestStored());
    whole.slope = -whole.slope;
  }
  return whole;
}

// The common case: all bits are stored, slope and intercept are whole and no voxel is padding. The
// loops are vector instructions. Returns nothing where it is another case, else whether Scalar
// holds all values.
template <typename Pixel, typename Scalar>
std::optional<bool> ConvertWhole(const char* bytes, std::size_t count, const WholeRescale& rescale,
  const DicomImage& image, const std::optional<Scalar>& marker, Scalar* values)
{
  Pixel lowest = StoredAt<Pixel>(bytes, 0);
  Pixel highest = lowest;
  for (std::size_t index = 0; index < count; ++index)
  {
    const Pixel pixel = StoredAt<Pixel>(bytes, index);
    lowest = std::min(lowest, pixel);
    highest = std::max(highest, pixel);
  }
  if (image.padding && lowest <= (*image.padding)[1] && highest >= (*image.padding)[0])
  {
    return std::nullopt;
  }
  const auto [smallest, largest] = std::minmax({ rescale(lowest), rescale(highest) });
  if (marker && smallest <= *marker && largest >= *marker)
  {
    return std::nullopt;
  }
  if (smallest < static_cast<std::int64_t>(std::numeric_limits<Scalar>::lowest()) ||
    largest > static_cast<std::int64_t>(std::numeric_limits<Scalar>::max()))
  {
    return false;
  }
  // Modulo the size of Scalar, which holds the results, intermediate overflow cancels out.
  using Unsigned = std::make_unsigned_t<Scalar>;
  const auto slope = static_cast<Unsigned>(rescale.slope);
  const auto intercept = static_cast<Unsigned>(rescale.intercept);
  for (std::size_t index = 0; index < count; ++index)
  {
    const auto pixel = static_cast<Unsigned>(StoredAt<Pixel>(bytes, index));
    values[index] = static_cast<Scalar>(static_cast<Unsigned>(slope * pixel + intercept));
  }
  return true;
}

template <typename Pixel, typename Scalar>
DicomConversion ConvertPixels(const char* bytes, std::size_t count, const DicomPixelFormat& pixel,
  const DicomImage& image, const DicomRescale& rescale, const std::optional<Scalar>& marker,
  Scalar* values)
{
  if constexpr (std::is_integral_v<Scalar>)
  {
    const auto whole = ToWhole(pixel, image, rescale);
    if (whole && pixel.bitsStored == pixel.bitsAllocated)
    {
      const auto isHeld = pixel.isSigned
        ? ConvertWhole<std::make_signed_t<Pixel>>(bytes, count, *whole, image, marker, values)
        : ConvertWhole<Pixel>(bytes, count, *whole, image, marker, values);
      if (isHeld)
      {
        return { *isHeld, false };
      }
    }
  }
  const StoredToValue convert(pixel, image, rescale);
  return ConvertAll<Pixel>(bytes, count, convert, marker, values);
}

}

template <typename Scalar>
std::optional<Scalar> PaddingMarker(const DicomValues& values)
{
  if (!values.hasPadding)
  {
    return std::nullopt;
  }
  if (std::is_floating_point_v<Scalar> || !values.padding)
  {
    return std::numeric_limits<Scalar>::quiet_NaN();
  }
  const Converted<Scalar> converted = ToScalar<Scalar>(*values.padding);
  return converted.isHeld ? converted.value : std::numeric_limits<Scalar>::lowest();
}

template <typename Scalar>
DicomConversion ConvertFrame(const DicomPixels& pixels, const DicomImage& image, std::size_t frame,
  const std::optional<Scalar>& marker, Scalar* values)
{
  const std::size_t count =
    static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  const std::size_t pixelBytes = static_cast<std::size_t>(pixels.format.bitsAllocated) / 8;
  const char* bytes = pixels.bytes.data() + frame * count * pixelBytes;
  const DicomRescale& rescale = image.frames[frame].rescale;
  const DicomPixelFormat& format = pixels.format;
  switch (pixelBytes)
  {
    case 1:
      return ConvertPixels<std::uint8_t>(bytes, count, format, image, rescale, marker, values);
    case 2:
      return ConvertPixels<std::uint16_t>(bytes, count, format, image, rescale, marker, values);
    default:
      return ConvertPixels<std::uint32_t>(bytes, count, format, image, rescale, marker, values);
  }
}

template <typename Scalar>
std::size_t FillPadding(const std::optional<Scalar>& marker, Scalar* values, std::size_t count)
{
  if (!marker)
  {
    return 0;
  }
  const auto isMarked = [&marker](Scalar value)
  { return value == *marker || (value != value && *marker != *marker); };
  Scalar lowest = std::numeric_limits<Scalar>::max();
  Scalar highest = std::numeric_limits<Scalar>::lowest();
  std::size_t marked = count;
  for (std::size_t index = 0; index < count; ++index)
  {
    if (!isMarked(values[index]))
    {
      lowest = std::min(lowest, values[index]);
      highest = std::max(highest, values[index]);
      --marked;
    }
  }
  const double below = static_cast<double>(lowest) - static_cast<double>(*marker);
  const double range = static_cast<double>(highest) - static_cast<double>(lowest);
  const bool isNear = below > 0.0 && below <= FarBelow * range;
  if (marked < count && isNear)
  {
    return 0;
  }
  std::replace_if(values, values + count, isMarked, marked < count ? lowest : Scalar(0));
  return marked;
}

#define InstantiateForScalar(Scalar)                                                               \
  template std::optional<Scalar> PaddingMarker<Scalar>(const DicomValues&);                        \
  template DicomConversion ConvertFrame<Scalar>(                                                   \
    const DicomPixels&, const DicomImage&, std::size_t, const std::optional<Scalar>&, Scalar*);    \
  template std::size_t FillPadding<Scalar>(const std::optional<Scalar>&, Scalar*, std::size_t)

InstantiateForScalar(std::uint8_t);
InstantiateForScalar(std::int8_t);
InstantiateForScalar(std::uint16_t);
InstantiateForScalar(std::int16_t);
InstantiateForScalar(std::uint32_t);
InstantiateForScalar(std::int32_t);
InstantiateForScalar(float);
InstantiateForScalar(double);

}
