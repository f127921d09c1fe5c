/**
 * @class   DicomStream
 * @brief   a DICOM file as GDCM is to read it
 *
 * GDCM fills up what a file lacks at its end without a word; here it shows.
 */

#ifndef DicomStream_h
#define DicomStream_h

#include <gdcmReader.h>

#include <filesystem>
#include <fstream>
#include <istream>

namespace penumbra
{

class DicomStream
{
public:
  /**
   * Opens `path` for `reader`, which must not outlive this. Throws VolumeReadingError where it does
   * not start as DICOM files do.
   */
  DicomStream(const std::filesystem::path& path, gdcm::Reader& reader);

  /**
   * Throws VolumeReadingError where more was asked for than the file has.
   */
  void ThrowIfCutShort() const;

private:
  class Buffer : public std::filebuf
  {
  public:
    bool IsCutShort = false;

  protected:
    std::streamsize xsgetn(char* bytes, std::streamsize count) override;
  };

  Buffer File;
  std::istream Stream;
};

}

#endif
