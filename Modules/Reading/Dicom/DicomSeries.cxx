#include "DicomSeries.h"

#include <algorithm>
#include <map>
#include <utility>

namespace penumbra
{

namespace
{

using SeriesKey = std::vector<std::string>;

SeriesKey KeyOf(const DicomImage& image)
{
  if (!image.seriesInstanceUID.empty())
  {
    return { image.seriesInstanceUID };
  }
  return { image.studyInstanceUID, image.seriesNumber, image.modality, image.seriesDescription,
    image.frameOfReferenceUID };
}

}

std::size_t DicomSeries::NumberOfImages() const
{
  std::size_t count = 0;
  for (const DicomFile& file : this->files)
  {
    count += file.image.frames.size();
  }
  return count;
}

std::uint64_t DicomSeries::NumberOfVoxels() const
{
  std::uint64_t count = 0;
  for (const DicomFile& file : this->files)
  {
    count += static_cast<std::uint64_t>(file.image.columns) *
      static_cast<std::uint64_t>(file.image.rows) * file.image.frames.size();
  }
  return count;
}

std::vector<DicomSeries> GroupBySeries(std::vector<DicomFile> files)
{
  std::vector<DicomSeries> all;
  std::map<SeriesKey, std::size_t> places;
  int withoutName = 0;
  for (DicomFile& file : files)
  {
    const auto [place, isNew] = places.emplace(KeyOf(file.image), all.size());
    if (isNew)
    {
      const std::string& uid = file.image.seriesInstanceUID;
      all.push_back({ uid.empty() ? "without-uid-" + std::to_string(++withoutName) : uid, {} });
    }
    all[place->second].files.push_back(std::move(file));
  }
  std::stable_sort(all.begin(), all.end(),
    [](const DicomSeries& left, const DicomSeries& right)
    { return left.NumberOfVoxels() > right.NumberOfVoxels(); });
  return all;
}

}
