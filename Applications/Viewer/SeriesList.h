/**
 * @file    SeriesList.h
 * @brief   the series of a DICOM folder
 */

#ifndef SeriesList_h
#define SeriesList_h

#include "SceneVolume.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

/// Nothing of the patient.
struct SeriesFacts
{
  std::string Uid;
  std::string Modality;
  std::string Description;
  int Slices = 0;
  int Columns = 0;
  int Rows = 0;
};

/// Those with most voxels first. Empty where there is none, where the folder cannot be read, and
/// where it was not to go on.
std::vector<SeriesFacts> ListSeries(
  const std::filesystem::path& folder, const VoxelReading& reading);

}

#endif
