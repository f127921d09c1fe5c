/**
 * @class   DicomStream
 * @brief   a DICOM file as GDCM is to read it
 *
 * GDCM jumps to and fro in files of some writers by single bytes, and fills up what a file lacks at
 * its end without a word. Here jumps are cheap and the lack shows.
 */

#ifndef DicomStream_h
#define DicomStream_h

#include <gdcmReader.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <vector>

namespace penumbra
{

/**
 * The Pixel Data element at which reading has stopped.
 */
struct DicomPixelElement
{
  /// In bytes.
  std::uint64_t length = 0;
  /// Whether it is written in words of 16 bits.
  bool isWords = false;
};

class DicomStream
{
public:
  /**
   * Opens `path` for `reader`, which can read for as long as this lasts. Throws VolumeReadingError
   * where it is no file or does not start as DICOM files do.
   */
  DicomStream(const std::filesystem::path& path, gdcm::Reader& reader);

  /// Of the file, in bytes.
  std::uint64_t GetSize() const;

  /**
   * The element whose value follows, after GDCM has read up to the uncompressed Pixel Data. Throws
   * VolumeReadingError where it is another, or longer than the rest of the file.
   */
  DicomPixelElement ReadPixelElement(const gdcm::TransferSyntax& syntax);

  /**
   * The bytes that follow. Throws VolumeReadingError where there are fewer.
   */
  void Read(char* bytes, std::size_t count);

  /**
   * Throws VolumeReadingError where more was asked for than the file has.
   */
  void ThrowIfCutShort() const;

private:
  // Holds a part of the file, within which seeking moves nothing.
  class Buffer : public std::streambuf
  {
  public:
    Buffer();
    bool Open(const std::filesystem::path& path);
    off_type GetSize() const { return this->FileSize; }
    bool IsCutShort() const { return this->CutShort; }

  protected:
    int_type underflow() override;
    std::streamsize xsgetn(char* bytes, std::streamsize count) override;
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode which) override;
    pos_type seekpos(pos_type position, std::ios::openmode which) override;

  private:
    off_type Position() const { return this->WindowStart + (this->gptr() - this->eback()); }
    std::streamsize TakeFromWindow(char* bytes, std::streamsize count);

    std::filebuf File;
    std::vector<char> Window;
    off_type WindowStart = 0;
    off_type FileSize = 0;
    bool CutShort = false;
  };

  Buffer Bytes;
  std::istream Stream;
};

}

#endif
