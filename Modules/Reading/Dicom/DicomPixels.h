/**
 * @class   DicomPixels
 * @brief   the pixels of a DICOM file, as stored
 */

#ifndef DicomPixels_h
#define DicomPixels_h

#include "DicomImage.h"

#include <gdcmDataElement.h>

#include <filesystem>
#include <vector>

namespace penumbra
{

class DicomPixels
{
public:
  DicomPixels() = default;

  /// Pixels that are stored as they are; `element` is Pixel Data.
  DicomPixels(const DicomPixelFormat& format, const gdcm::DataElement& element);

  /// Pixels that were decoded.
  DicomPixels(const DicomPixelFormat& format, std::vector<char> bytes);

  /// Of the pixels themselves; a compressed file's may differ from what its header says.
  const DicomPixelFormat& GetFormat() const { return this->Format; }

  /// All frames, in the byte order of this machine.
  const char* GetBytes() const;

private:
  DicomPixelFormat Format;
  gdcm::DataElement Stored;
  std::vector<char> Decoded;
};

/**
 * Decodes all frames of `path`, whose header `image` is. Throws VolumeReadingError where they
 * cannot be decoded or are not what the header says. GDCM may end the process instead.
 */
DicomPixels ReadDicomPixels(const std::filesystem::path& path, const DicomImage& image);

}

#endif
