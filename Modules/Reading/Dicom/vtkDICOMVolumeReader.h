/**
 * @class   vtkDICOMVolumeReader
 * @brief   reads one DICOM series as a volume that lies where the scanner saw it
 *
 * The input is a file, a folder, a DICOMDIR or a list of files. A folder is searched with all its
 * subfolders; files in it that hold no DICOM image do not matter. Of several series the one that
 * SetSeries names is read, or else the one with the most voxels.
 *
 * The output is a vtkImageData of one scalar per voxel in DICOM's patient coordinates: millimetres,
 * x towards the patient's left, y towards the back, z towards the head (LPS). Voxel (i, j, k) is at
 * origin + direction * ((i, j, k) * spacing); i runs along a row, j along a column, k along the
 * normal, which is the cross product of both (DICOM PS3.3, C.7.6.2.1.1).
 *
 * - Slices are ordered and spaced by Image Position (Patient) along the normal.
 * - A gantry tilt leaves the slices where they are: the third column of the direction matrix is
 *   then not perpendicular to the others. Nothing is resampled.
 * - Where slices are missing or unevenly spaced, the volume has even slices, interpolated linearly
 *   between the two that enclose them.
 * - Of several images at one position the first is taken, by temporal position, echo time,
 *   acquisition number, instance number. Images of another orientation, size or pixel spacing than
 *   most are left out.
 * - Scalars are Rescale Slope * stored + Rescale Intercept, of each slice by its own. They have the
 *   smallest integer type that holds them, if slopes and intercepts are whole; else they are
 *   float32 (float64 for stored values of more than 24 bits).
 * - Voxels of the padding value, or within the padding range, get the lowest value of all others,
 *   unless their own is just below it (by a twentieth of the range of the others or less).
 * - MONOCHROME1 says that small values are shown bright. Values that have a unit (CT, PET, doses,
 *   or by Rescale Type) are kept; others are turned over within their stored bits.
 *
 * What of this was done is told in GetWarnings, with numbers. What cannot be read so is refused:
 * colour images, images without pixels, frames that are moments in time, mosaics, pixels of one bit
 * or of floating point, values that go through a Modality LUT.
 *
 * GDCM ends the process on some malformed files. With SetParserProgram all parsing is done by that
 * program, in a process of its own with limits; a file that it fails on is left out, or where it is
 * the only one, refused.
 *
 * The field data of the output names "Modality" (such as CT), "Units" (such as HU, or nothing) and
 * "SeriesInstanceUID". Names and other data of the patient are not read.
 *
 * An error is reported by vtkErrorMacro as one line and by the error code; the output is then
 * empty, and the next update after a change tries again. Progress is reported by
 * vtkCommand::ProgressEvent, and AbortExecute set there ends the reading.
 */

#ifndef vtkDICOMVolumeReader_h
#define vtkDICOMVolumeReader_h

#include "PenumbraReadingModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkDataArray;
class vtkImageData;
class vtkStringArray;

class PENUMBRAREADING_EXPORT vtkDICOMVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkDICOMVolumeReader* New();
  vtkTypeMacro(vtkDICOMVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, folder or DICOMDIR to read, in UTF-8. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Files to read instead of FileName, in any order. Default: none.
   */
  virtual void SetFileNames(vtkStringArray* names);
  vtkGetObjectMacro(FileNames, vtkStringArray);
  ///@}

  ///@{
  /**
   * The Series Instance UID of the series to read, or what GetSeriesName gives for it. Default:
   * none, which is the series with the most voxels.
   */
  vtkSetStringMacro(Series);
  vtkGetStringMacro(Series);
  ///@}

  ///@{
  /**
   * The program penumbra-dicom-parser, which then does all parsing. Default: none, everything is
   * done in this process.
   */
  vtkSetFilePathMacro(ParserProgram);
  vtkGetFilePathMacro(ParserProgram);
  ///@}

  ///@{
  /**
   * The most memory in bytes that files and voxels may take, beside what the parser program needs
   * for itself. Default: 0, which is half of the machine's memory.
   */
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

  ///@{
  /**
   * Seconds that the parser program may spend on one file, and one more for each MiB of it.
   * Range: 0.01 to 1e6. Default: 8.
   */
  vtkSetClampMacro(TimeLimit, double, 0.01, 1e6);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * The series found by UpdateInformation, the one with the most voxels first. A name is the Series
   * Instance UID, or where there is none "without-uid-1" and so on. Where there is no such series,
   * texts are null and numbers 0.
   */
  int GetNumberOfSeries();
  const char* GetSeriesName(int series);
  const char* GetSeriesModality(int series);
  const char* GetSeriesDescription(int series);
  int GetSeriesNumberOfImages(int series);
  int GetSeriesColumns(int series);
  int GetSeriesRows(int series);
  ///@}

  /**
   * What a user should know about the volume, one line each. Complete after Update.
   */
  vtkStringArray* GetWarnings();

  /**
   * The error of the last update, one line, or an empty text.
   */
  const char* GetErrorMessage();

  /**
   * With that of FileNames.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkDICOMVolumeReader();
  ~vtkDICOMVolumeReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkDICOMVolumeReader(const vtkDICOMVolumeReader&) = delete;
  void operator=(const vtkDICOMVolumeReader&) = delete;

  void FindVolume();
  vtkSmartPointer<vtkDataArray> ReadVoxels();
  void DescribeVolume(vtkImageData* volume);
  void TakeWarnings();
  std::string DescribeInput() const;

  char* FileName = nullptr;
  vtkStringArray* FileNames = nullptr;
  char* Series = nullptr;
  char* ParserProgram = nullptr;
  vtkTypeUInt64 MemoryLimit = 0;
  double TimeLimit = 8.0;

  class Internals;
  std::unique_ptr<Internals> State;
};

#endif
