/**
 * @class   DicomParser
 * @brief   what touches DICOM files: headers and voxels
 *
 * It may do so in this process (LocalDicomParser) or in another one (DicomParserProcess).
 */

#ifndef DicomParser_h
#define DicomParser_h

#include "DicomVolumePlan.h"
#include "VolumeReadingError.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

class vtkDataArray;

namespace penumbra
{

/**
 * Told how far a task is, 0 to 1; returns whether to go on.
 */
using ReadingProgress = std::function<bool(double)>;

/**
 * The user does not want to go on.
 */
class ReadingCancelled : public VolumeReadingError
{
public:
  ReadingCancelled()
    : VolumeReadingError("cancelled")
  {
  }
};

/**
 * One of several files cannot be read.
 */
class DicomFileError : public VolumeReadingError
{
public:
  DicomFileError(std::size_t file, const std::string& reason)
    : VolumeReadingError(reason)
    , File(file)
  {
  }

  /// Its index in the list of files.
  std::size_t File;
};

/**
 * A file's image, or why it has none.
 */
using DicomHeaderResult = std::variant<DicomImage, std::string>;

struct DicomVoxelArray
{
  vtkSmartPointer<vtkDataArray> values;
  /// How many voxels without a measurement have got the value of another.
  std::size_t filled = 0;
};

class DicomParser
{
public:
  virtual ~DicomParser() = default;

  /**
   * A result for each file, in their order. Throws ReadingCancelled.
   */
  virtual std::vector<DicomHeaderResult> ReadHeaders(
    const std::vector<std::filesystem::path>& paths, const ReadingProgress& progress) = 0;

  /**
   * The files that a DICOMDIR names. Throws VolumeReadingError.
   */
  virtual std::vector<std::filesystem::path> ReadDirectory(const std::filesystem::path& path) = 0;

  /**
   * The voxels of `plan`, x fastest. Throws DicomFileError, ReadingCancelled, or std::bad_alloc.
   */
  virtual DicomVoxelArray ReadVoxels(const std::vector<DicomFile>& files,
    const DicomVolumePlan& plan, const ReadingProgress& progress) = 0;
};

}

#endif
