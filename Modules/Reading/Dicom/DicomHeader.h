/**
 * @file    DicomHeader.h
 * @brief   what a DICOM file says about its image
 */

#ifndef DicomHeader_h
#define DicomHeader_h

#include "DicomImage.h"

#include <filesystem>

namespace penumbra
{

/**
 * Reads all of `path` before its pixels. Throws VolumeReadingError where it is no DICOM file, is
 * damaged or holds nothing that can be a part of a volume. GDCM may end the process instead.
 */
DicomImage ReadDicomHeader(const std::filesystem::path& path);

}

#endif
