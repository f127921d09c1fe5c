/**
 * @file    FileContent.h
 * @brief   what a file holds, going by its first bytes
 */

#ifndef FileContent_h
#define FileContent_h

#include <filesystem>

namespace penumbra
{

enum class FileContent
{
  Unknown,
  Dicom,
  Gzip,
  MetaImage,
  Nifti,
  Nrrd,
  Xml
};

/**
 * Throws VolumeReadingError where the file is missing, empty, no file or unreadable.
 */
FileContent ContentOf(const std::filesystem::path& path);

/**
 * The content in words, to follow "the content is ".
 */
const char* ContentName(FileContent content);

}

#endif
