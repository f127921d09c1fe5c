/**
 * @file    DicomScalars.h
 * @brief   stored pixels to the scalars of a volume
 */

#ifndef DicomScalars_h
#define DicomScalars_h

#include "DicomImage.h"
#include "DicomPixels.h"
#include "DicomValues.h"

#include <cstddef>
#include <optional>

namespace penumbra
{

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
