/**
 * @file    DicomVolumePlan.h
 * @brief   which slices of a series make up its volume, and where it lies
 */

#ifndef DicomVolumePlan_h
#define DicomVolumePlan_h

#include "DicomSeries.h"
#include "VolumeGeometry.h"

#include <cstddef>
#include <string>
#include <vector>

namespace penumbra
{

/**
 * A slice as scanned.
 */
struct DicomSource
{
  std::size_t file = 0;
  std::size_t frame = 0;
  /// Which slice of the volume it is; between two where it is not whole.
  double place = 0.0;
};

/**
 * A slice of the volume: (1 - weight) * below + weight * above, each an index of a source.
 */
struct DicomVolumeSlice
{
  std::size_t below = 0;
  std::size_t above = 0;
  double weight = 0.0;
};

struct DicomVolumePlan
{
  VolumeGeometry geometry;
  /// Along the normal.
  std::vector<DicomSource> sources;
  std::vector<DicomVolumeSlice> slices;
};

/**
 * Plans the volume of `series`, as vtkDICOMVolumeReader describes. What is not taken as it is, is
 * told in `warnings`. Throws VolumeReadingError where no volume with right geometry can be made.
 */
DicomVolumePlan PlanVolume(const DicomSeries& series, std::vector<std::string>& warnings);

/**
 * Leaves out the slices of one file, in whose place others are interpolated, or at an end the next
 * one repeated. Returns false, and changes nothing, where less than half of the slices would
 * remain.
 */
bool LeaveOutFile(DicomVolumePlan& plan, std::size_t file);

}

#endif
