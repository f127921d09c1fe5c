/**
 * @file    DicomSeries.h
 * @brief   images told apart by the series that they belong to
 */

#ifndef DicomSeries_h
#define DicomSeries_h

#include "DicomImage.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{

struct DicomFile
{
  std::filesystem::path path;
  DicomImage image;
};

struct DicomSeries
{
  /// The Series Instance UID, or "without-uid-1" and so on.
  std::string name;
  std::vector<DicomFile> files;

  std::size_t NumberOfImages() const;
  std::uint64_t NumberOfVoxels() const;
};

/**
 * The series of `files`, the one with the most voxels first, else in the order of the files.
 * Without a Series Instance UID, images are of one series if they agree in study, series number,
 * modality, description and frame of reference.
 */
std::vector<DicomSeries> GroupBySeries(std::vector<DicomFile> files);

}

#endif
