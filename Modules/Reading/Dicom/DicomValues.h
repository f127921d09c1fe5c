/**
 * @file    DicomValues.h
 * @brief   the values that the slices of a volume can have, and the scalar types that hold them
 */

#ifndef DicomValues_h
#define DicomValues_h

#include "DicomImage.h"

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

}

#endif
