#include "DicomVolumeReading.h"

#include "DicomFiles.h"
#include "NumberText.h"
#include "OneLine.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace penumbra
{

namespace
{

namespace fs = std::filesystem;

// More is no series with a few bad files.
constexpr std::size_t MostUnreadableFiles = 16;

std::string NameOf(const fs::path& path)
{
  return path.filename().u8string();
}

std::string InWords(const DicomSeries& series)
{
  const DicomImage& image = series.files.front().image;
  std::string text = series.name + " (" + (image.modality.empty() ? "" : image.modality + ", ");
  if (!image.seriesDescription.empty())
  {
    text += "\"" + image.seriesDescription + "\", ";
  }
  return text + CountText(series.NumberOfImages(), "image") + " of " +
    std::to_string(image.columns) + "x" + std::to_string(image.rows) + ")";
}

std::string InWords(const std::vector<DicomSeries>& all)
{
  constexpr std::size_t mostNamed = 10;
  std::string text;
  for (std::size_t index = 0; index < std::min(all.size(), mostNamed); ++index)
  {
    text += (index == 0 ? "" : ", ") + InWords(all[index]);
  }
  return all.size() <= mostNamed
    ? text
    : text + " and " + std::to_string(all.size() - mostNamed) + " more";
}

// The files of a DICOMDIR that are there.
std::vector<fs::path> ExistingFiles(
  const fs::path& path, DicomParser& parser, std::vector<std::string>& warnings)
{
  const std::vector<fs::path> named = parser.ReadDirectory(path);
  std::vector<fs::path> existing;
  std::copy_if(named.begin(), named.end(), std::back_inserter(existing),
    [](const fs::path& file)
    {
      std::error_code ignored;
      return fs::is_regular_file(file, ignored);
    });
  if (existing.empty())
  {
    throw VolumeReadingError(
      "it names " + CountText(named.size(), "file") + ", of which none exists");
  }
  if (existing.size() < named.size())
  {
    warnings.push_back(CountText(named.size() - existing.size(), "file") + " of " +
      std::to_string(named.size()) + " that the DICOMDIR names do not exist");
  }
  return existing;
}

}

void DicomVolumeReading::FindSeries(
  const fs::path& path, DicomParser& parser, const ReadingProgress& progress)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
  {
    throw VolumeReadingError("there is no such file or folder");
  }
  if (fs::is_directory(path, ignored))
  {
    const std::vector<fs::path> files = FindDicomFiles(path, progress);
    if (files.empty())
    {
      throw VolumeReadingError("the folder holds no DICOM files");
    }
    this->FindSeries(files, parser, progress);
    return;
  }
  if (IsDicomDirectory(path))
  {
    std::vector<std::string> warnings;
    const std::vector<fs::path> files = ExistingFiles(path, parser, warnings);
    this->FindSeries(files, parser, progress);
    this->FindingWarnings.insert(this->FindingWarnings.begin(), warnings.begin(), warnings.end());
    return;
  }
  this->FindSeries(std::vector<fs::path>{ path }, parser, progress);
  if (this->Series.front().NumberOfImages() == 1)
  {
    this->FindingWarnings.push_back("the file holds one slice; its folder may hold the others");
  }
}

void DicomVolumeReading::FindSeries(
  const std::vector<fs::path>& paths, DicomParser& parser, const ReadingProgress& progress)
{
  std::vector<DicomHeaderResult> results = parser.ReadHeaders(paths, progress);
  std::vector<DicomFile> files;
  std::string firstFailure;
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    if (auto* image = std::get_if<DicomImage>(&results[index]))
    {
      files.push_back({ paths[index], std::move(*image) });
    }
    else if (firstFailure.empty())
    {
      firstFailure = (paths.size() == 1 ? "" : NameOf(paths[index]) + ": ") +
        std::get<std::string>(results[index]);
    }
  }
  if (files.empty())
  {
    throw VolumeReadingError(paths.size() == 1 ? firstFailure
                                               : "none of its " + CountText(paths.size(), "file") +
          " can be a part of a volume; " + firstFailure);
  }
  this->FindingWarnings.clear();
  if (files.size() < paths.size())
  {
    this->FindingWarnings.push_back(std::to_string(paths.size() - files.size()) + " of " +
      CountText(paths.size(), "DICOM file") + " left out; " + firstFailure);
  }
  this->Series = GroupBySeries(std::move(files));
}

void DicomVolumeReading::SelectSeries(const std::string& name)
{
  this->SelectionWarnings.clear();
  if (name.empty())
  {
    this->SelectLargest();
    return;
  }
  const auto selected = std::find_if(this->Series.begin(), this->Series.end(),
    [&name](const DicomSeries& series) { return series.name == name; });
  if (selected == this->Series.end())
  {
    throw VolumeReadingError(
      "it has no series \"" + name + "\"; there is " + InWords(this->Series));
  }
  this->Selected = *selected;
  this->PlanSelected();
}

void DicomVolumeReading::SelectLargest()
{
  std::string firstReason;
  for (const DicomSeries& series : this->Series)
  {
    this->Selected = series;
    try
    {
      this->PlanSelected();
    }
    catch (const VolumeReadingError& error)
    {
      firstReason = firstReason.empty() ? error.what() : firstReason;
      this->SelectionWarnings.push_back(
        "the series " + series.name + " is no volume: " + error.what());
      continue;
    }
    this->TellOtherSeries();
    return;
  }
  throw VolumeReadingError(firstReason);
}

void DicomVolumeReading::TellOtherSeries()
{
  if (this->Series.size() < 2)
  {
    return;
  }
  std::vector<DicomSeries> others;
  std::copy_if(this->Series.begin(), this->Series.end(), std::back_inserter(others),
    [this](const DicomSeries& series) { return series.name != this->Selected.name; });
  this->SelectionWarnings.push_back("of " + std::to_string(this->Series.size()) +
    " series the largest is taken, " + InWords(this->Selected) + "; others: " + InWords(others));
}

void DicomVolumeReading::PlanSelected()
{
  this->PlanWarnings.clear();
  this->Plan = PlanVolume(this->Selected, this->PlanWarnings);
}

void DicomVolumeReading::LeaveOut(const DicomFileError& error)
{
  const std::string name = NameOf(this->Selected.files[error.File].path);
  if (this->Selected.files.size() == 1)
  {
    throw VolumeReadingError(error.what());
  }
  if (++this->UnreadableFiles > MostUnreadableFiles || !LeaveOutFile(this->Plan, error.File))
  {
    throw VolumeReadingError("too many of its files cannot be read; " + name + ": " + error.what());
  }
  this->ReadingWarnings.push_back(
    name + " is left out and its slices filled from those beside them: " + error.what());
}

void DicomVolumeReading::TellFilled(const DicomVoxelArray& voxels)
{
  this->PaddingWarnings.clear();
  if (voxels.filled > 0)
  {
    this->PaddingWarnings.push_back(CountText(voxels.filled, "voxel") +
      " without a measurement (Pixel Padding Value): these have the lowest value of the others");
  }
}

vtkSmartPointer<vtkDataArray> DicomVolumeReading::ReadVoxels(
  DicomParser& parser, const ReadingProgress& progress)
{
  while (true)
  {
    try
    {
      const DicomVoxelArray voxels = parser.ReadVoxels(this->Selected.files, this->Plan, progress);
      this->TellFilled(voxels);
      return voxels.values;
    }
    catch (const DicomFileError& error)
    {
      this->LeaveOut(error);
    }
  }
}

std::vector<std::string> DicomVolumeReading::GetWarnings() const
{
  std::vector<std::string> all;
  for (const auto* warnings : { &this->FindingWarnings, &this->SelectionWarnings,
         &this->ReadingWarnings, &this->PlanWarnings, &this->PaddingWarnings })
  {
    std::transform(warnings->begin(), warnings->end(), std::back_inserter(all), OneLine);
  }
  return all;
}

}
