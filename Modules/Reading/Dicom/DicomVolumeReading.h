/**
 * @class   DicomVolumeReading
 * @brief   the steps from paths to a volume, independent of VTK's pipeline
 */

#ifndef DicomVolumeReading_h
#define DicomVolumeReading_h

#include "DicomParser.h"
#include "DicomSeries.h"
#include "DicomVolumePlan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

class DicomVolumeReading
{
public:
  /**
   * Finds the series of `path`, a file, folder or DICOMDIR, or of several files. What is left out
   * is told in the warnings. Throws VolumeReadingError where there is none, and ReadingCancelled.
   */
  void FindSeries(
    const std::filesystem::path& path, DicomParser& parser, const ReadingProgress& progress);
  void FindSeries(const std::vector<std::filesystem::path>& paths, DicomParser& parser,
    const ReadingProgress& progress);

  /**
   * Plans the volume of the series `name`, or where that is empty, of the first one that makes up a
   * volume. Throws VolumeReadingError.
   */
  void SelectSeries(const std::string& name);

  /**
   * The voxels of the selected series. Files that turn out to be unreadable are left out, their
   * slices filled from those beside them; the geometry stays. Throws VolumeReadingError,
   * ReadingCancelled, std::bad_alloc.
   */
  vtkSmartPointer<vtkDataArray> ReadVoxels(DicomParser& parser, const ReadingProgress& progress);

  const std::vector<DicomSeries>& GetSeries() const { return this->Series; }
  const DicomVolumePlan& GetPlan() const { return this->Plan; }
  const DicomSeries& GetSelected() const { return this->Selected; }
  std::vector<std::string> GetWarnings() const;

private:
  void TellFilled(const DicomVoxelArray& voxels);
  void LeaveOut(const DicomFileError& error);
  void PlanSelected();
  void SelectLargest();
  void TellOtherSeries();

  std::vector<DicomSeries> Series;
  DicomSeries Selected;
  DicomVolumePlan Plan;
  std::size_t UnreadableFiles = 0;
  std::vector<std::string> FindingWarnings;
  std::vector<std::string> SelectionWarnings;
  std::vector<std::string> PlanWarnings;
  std::vector<std::string> ReadingWarnings;
  std::vector<std::string> PaddingWarnings;
};

}

#endif
