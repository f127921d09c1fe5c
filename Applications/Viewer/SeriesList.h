/**
 * @file    SeriesList.h
 * @brief   the series of a DICOM folder
 */

#ifndef SeriesList_h
#define SeriesList_h

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

/// Those with most voxels first. Empty where there is none, or where the folder cannot be read.
std::vector<SeriesFacts> ListSeries(
  const std::filesystem::path& folder, const std::filesystem::path& dicomParser);

}

#endif
