/**
 * @file    DicomDirectory.h
 * @brief   the files that a DICOMDIR names
 */

#ifndef DicomDirectory_h
#define DicomDirectory_h

#include <filesystem>
#include <vector>

namespace penumbra
{

/**
 * The files that the DICOMDIR `path` names (DICOM PS3.3, F.3), each once and whether it exists or
 * not. Throws VolumeReadingError where it cannot be read. GDCM may end the process instead.
 */
std::vector<std::filesystem::path> ReadDicomDirectory(const std::filesystem::path& path);

}

#endif
