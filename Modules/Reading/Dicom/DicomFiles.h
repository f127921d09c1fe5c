/**
 * @file    DicomFiles.h
 * @brief   the files that may hold DICOM images
 */

#ifndef DicomFiles_h
#define DicomFiles_h

#include "DicomParser.h"

#include <filesystem>
#include <vector>

namespace penumbra
{

/**
 * Whether the file starts as DICOM files do, with or without a preamble, going by a few bytes.
 */
bool MayBeDicom(const std::filesystem::path& path);

/**
 * Whether the file is a DICOMDIR, by its name.
 */
bool IsDicomDirectory(const std::filesystem::path& path);

/**
 * The files in `folder` and its subfolders that may be DICOM images, sorted, each once. Throws
 * VolumeReadingError where the folder cannot be read or has more than a hundred thousand files, and
 * ReadingCancelled.
 */
std::vector<std::filesystem::path> FindDicomFiles(
  const std::filesystem::path& folder, const ReadingProgress& progress);

}

#endif
