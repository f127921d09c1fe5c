/**
 * @file    DicomScalars.h
 * @brief   stored pixels to the scalars of a volume
 */

#ifndef DicomScalars_h
#define DicomScalars_h

#include "DicomImage.h"
#include "DicomPixels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace penumbra
{

/**
 * What the slices of one volume have in common.
 */
struct DicomValues
{
  /// The lowest and the highest modality value that the stored bits allow for.
  std::array<double, 2> possible{};
  /// Whether all slopes and intercepts are whole numbers.
  bool areWhole = true;
  int mostBitsStored = 0;
  int mostBitsAllocated = 0;
  /// Whether any slice can have voxels without a measurement, and what these are by its slope and
  /// intercept; nothing where the slices differ in it.
  bool hasPadding = false;
  std::optional<double> padding;
};

/**
 * A slice: its file's image and the number of its frame.
 */
using DicomImageFrame = std::pair<const DicomImage*, std::size_t>;

DicomValues SummarizeValues(const std::vector<DicomImageFrame>& slices);

/**
 * The scalar types that the values may have, as VTK's constants, the most wanted first. All but the
 * last may turn out too small for the values that are there.
 */
std::vector<int> PossibleScalarTypes(const DicomValues& values);

/**
 * What stands for voxels without a measurement while slices are read, in a scalar type: NaN for
 * floating point types. Nothing where there is no padding.
 */
template <typename Scalar>
std::optional<Scalar> PaddingMarker(const DicomValues& values);

struct DicomConversion
{
  /// Whether the scalar type holds all values.
  bool isHeld = true;
  /// Whether any voxel has got the marker.
  bool hasPadding = false;
};

/**
 * The values of frame `frame`, padding as the marker.
 */
template <typename Scalar>
DicomConversion ConvertFrame(const DicomPixels& pixels, const DicomImage& image, std::size_t frame,
  const std::optional<Scalar>& marker, Scalar* values);

/**
 * Gives marked voxels the lowest of all other values and returns how many there are; or leaves a
 * marker that lies but a twentieth of their range below them, and returns 0.
 */
template <typename Scalar>
std::size_t FillPadding(const std::optional<Scalar>& marker, Scalar* values, std::size_t count);

}

#endif
