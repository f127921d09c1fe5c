/**
 * @file    DicomImage.h
 * @brief   what a DICOM file says about its image, as plain values
 *
 * Nothing in it names the patient.
 */

#ifndef DicomImage_h
#define DicomImage_h

#include "VolumeGeometry.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * A modality value is slope * stored + intercept (DICOM PS3.3, C.11.1.1.2).
 */
struct DicomRescale
{
  double slope = 1.0;
  double intercept = 0.0;

  /// Whether both are whole numbers of 32 bits.
  bool IsWhole() const
  {
    const auto isWhole = [](double number)
    { return std::abs(number) < 2147483648.0 && number == std::round(number); };
    return isWhole(this->slope) && isWhole(this->intercept);
  }
};

/**
 * One slice.
 */
struct DicomFrame
{
  /// Image Position (Patient): the centre of the first pixel, in mm.
  std::optional<Vector3> position;
  /// Image Orientation (Patient): the direction of a row, then of a column.
  std::optional<std::array<double, 6>> orientation;
  /// Pixel Spacing: the distance between rows, then between columns, in mm.
  std::optional<std::array<double, 2>> pixelSpacing;
  /// Whether it is that of the detector (Imager Pixel Spacing), on which bodies appear magnified.
  bool isSpacingAtDetector = false;
  std::optional<double> sliceThickness;
  std::optional<double> spacingBetweenSlices;
  DicomRescale rescale;
  /// What tells images of one position apart: temporal position, echo time, acquisition number,
  /// instance number and the number within the file.
  std::array<double, 5> order{};
};

/**
 * How a pixel is stored.
 */
struct DicomPixelFormat
{
  int bitsAllocated = 0;
  int bitsStored = 0;
  int highBit = 0;
  bool isSigned = false;

  /// Whether it is of 8, 16 or 32 bits and what is stored lies within them.
  bool IsUsable() const
  {
    return (this->bitsAllocated == 8 || this->bitsAllocated == 16 || this->bitsAllocated == 32) &&
      this->bitsStored >= 1 && this->bitsStored - 1 <= this->highBit &&
      this->highBit < this->bitsAllocated;
  }

  /// The lowest and the highest value that the stored bits allow for.
  std::int64_t LowestStored() const
  {
    return this->isSigned ? -(std::int64_t(1) << (this->bitsStored - 1)) : 0;
  }
  std::int64_t HighestStored() const
  {
    return (std::int64_t(1) << (this->isSigned ? this->bitsStored - 1 : this->bitsStored)) - 1;
  }

  bool operator==(const DicomPixelFormat& other) const
  {
    return this->bitsAllocated == other.bitsAllocated && this->bitsStored == other.bitsStored &&
      this->highBit == other.highBit && this->isSigned == other.isSigned;
  }
};

struct DicomImage
{
  std::string seriesInstanceUID;
  std::string studyInstanceUID;
  std::string frameOfReferenceUID;
  std::string seriesNumber;
  std::string seriesDescription;
  std::string modality;
  /// Unit of the modality values, such as HU; empty where none is known.
  std::string units;
  int columns = 0;
  int rows = 0;
  DicomPixelFormat pixel;
  /// Whether small values are shown bright (MONOCHROME1).
  bool isInverted = false;
  /// Whether these are turned over within the bits stored, for they have no unit.
  bool isTurnedOver = false;
  /// First and last stored value that stand for no measurement.
  std::optional<std::array<std::int64_t, 2>> padding;
  std::vector<DicomFrame> frames;
};

}

#endif
