/**
 * @file    AlikeSlices.h
 * @brief   the slices of a series that can be of one volume
 */

#ifndef AlikeSlices_h
#define AlikeSlices_h

#include "DicomVolumePlan.h"

#include <string>
#include <vector>

namespace penumbra
{

/**
 * A slice, with what its file says of it. Valid as long as the series.
 */
struct ScannedSlice
{
  DicomSource source;
  const DicomFile* file;
  const DicomFrame* frame;
};

/**
 * The largest group of slices that agree in size, orientation, pixel spacing, frame of reference
 * and kind; the others are told in `warnings`. Throws VolumeReadingError where no two of several
 * agree.
 */
std::vector<ScannedSlice> TakeAlikeSlices(
  const DicomSeries& series, std::vector<std::string>& warnings);

}

#endif
