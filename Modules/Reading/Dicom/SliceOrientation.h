/**
 * @file    SliceOrientation.h
 * @brief   how slices are turned, and how far apart their pixels and they themselves are
 */

#ifndef SliceOrientation_h
#define SliceOrientation_h

#include "DicomImage.h"

#include <string>
#include <vector>

namespace penumbra
{

/**
 * The common orientation of slices: unit vectors along a row, along a column and their cross
 * product, and the distances between columns and between rows, in mm.
 */
struct SliceOrientation
{
  Vector3 row{};
  Vector3 column{};
  Vector3 normal{};
  double columnSpacing = 1.0;
  double rowSpacing = 1.0;
};

/**
 * As the frame states it; what it does not state is assumed, and told in `warnings`. Throws
 * VolumeReadingError where its directions are no two perpendicular unit vectors.
 */
SliceOrientation OrientationOf(const DicomFrame& frame, std::vector<std::string>& warnings);

struct SliceDistance
{
  double millimetres = 1.0;
  std::string origin = "a guess";
};

/**
 * The distance between slices as far as one frame tells it, and what tells it.
 */
SliceDistance DistanceOf(const DicomFrame& frame, const SliceOrientation& orientation);

}

#endif
