/**
 * @file    SliceStack.h
 * @brief   slices of one orientation, put in order and spaced by where they lie
 */

#ifndef SliceStack_h
#define SliceStack_h

#include "DicomImage.h"
#include "DicomVolumePlan.h"
#include "SliceOrientation.h"

#include <array>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * A slice, and what is needed to place it.
 */
struct PlacedSlice
{
  DicomSource source;
  /// Of the first pixel.
  Vector3 position{};
  /// What tells slices of one position apart.
  std::array<double, 5> order{};
  /// Of the position, along the normal from the patient coordinates' origin, in mm.
  double location = 0.0;
};

/**
 * Sorts slices along the normal and leaves one at each location.
 */
void SortSlices(std::vector<PlacedSlice>& slices, const SliceOrientation& orientation,
  std::vector<std::string>& warnings);

/**
 * From one slice to the next, in mm per mm along the normal: the normal itself, or with a gantry
 * tilt a longer vector that is not perpendicular to the slices. Throws VolumeReadingError where the
 * slices are shifted irregularly. `slices` are sorted.
 */
Vector3 FindStackingDirection(const std::vector<PlacedSlice>& slices,
  const SliceOrientation& orientation, std::vector<std::string>& warnings);

/**
 * Even slices, and where sorted ones, of which there are two or more, lie among them.
 */
struct EvenSlices
{
  double spacing = 1.0;
  std::size_t count = 0;
  /// Of each slice, in even ones from the first; whole where it is an even one.
  std::vector<double> places;
};
EvenSlices SpaceEvenly(const std::vector<PlacedSlice>& slices, std::vector<std::string>& warnings);

}

#endif
