/**
 * @file    FormatReaders.h
 * @brief   the readers behind ReadVolumeFile, one for each format
 *
 * They throw VolumeReadingError with the problem alone; ReadVolumeFile adds which file it is.
 */

#ifndef FormatReaders_h
#define FormatReaders_h

#include "VolumeFile.h"

#include <filesystem>

namespace penumbra
{

using Volume = vtkSmartPointer<vtkImageData>;
using Warnings = std::vector<std::string>;

Volume ReadRawVolume(
  const std::filesystem::path& path, const RawVolumeGeometry& raw, Warnings& warnings);
Volume ReadMetaImageVolume(const std::filesystem::path& path, Warnings& warnings);
Volume ReadNrrdVolume(const std::filesystem::path& path, Warnings& warnings);
Volume ReadNiftiVolume(const std::filesystem::path& path, bool compressed, Warnings& warnings);
Volume ReadXmlImageVolume(const std::filesystem::path& path, Warnings& warnings);
Volume ReadDicomVolume(
  const std::filesystem::path& path, const VolumeReadingOptions& options, Warnings& warnings);

}

#endif
