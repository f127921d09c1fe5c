/**
 * @file    DicomPixels.h
 * @brief   the pixels of a DICOM file, as stored
 */

#ifndef DicomPixels_h
#define DicomPixels_h

#include "DicomImage.h"

#include <filesystem>
#include <vector>

namespace penumbra
{

struct DicomPixels
{
  /// Of the pixels themselves; a compressed file's may differ from what its header says.
  DicomPixelFormat format;
  /// All frames, in the byte order of this machine.
  std::vector<char> bytes;
};

/**
 * Decodes all frames of `path`, whose header `image` is. Throws VolumeReadingError where they
 * cannot be decoded or are not what the header says. GDCM may end the process instead.
 */
DicomPixels ReadDicomPixels(const std::filesystem::path& path, const DicomImage& image);

}

#endif
