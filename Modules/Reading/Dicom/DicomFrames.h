/**
 * @file    DicomFrames.h
 * @brief   where the frames of a file lie and what their values mean
 */

#ifndef DicomFrames_h
#define DicomFrames_h

#include "DicomDataSet.h"
#include "DicomImage.h"

namespace penumbra
{

/**
 * The frames of a file, in its order: from functional groups (DICOM PS3.3, C.7.6.16), a dose's grid
 * offsets (C.8.8.3.2), a nuclear image's slices (C.8.4.8) or one image's own attributes. Throws
 * VolumeReadingError where several frames are no slices of one volume, or where a file of
 * `fileSize` bytes cannot hold as many.
 */
std::vector<DicomFrame> ReadDicomFrames(const DicomDataSet& data, std::uint64_t fileSize);

}

#endif
