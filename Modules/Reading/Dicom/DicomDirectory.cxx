#include "DicomDirectory.h"

#include "DicomDataSet.h"
#include "DicomStream.h"
#include "DicomTags.h"
#include "VolumeReadingError.h"

#include <gdcmReader.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace penumbra
{

namespace
{

// The parts of a file's path are the values of one attribute.
std::filesystem::path ToPath(const std::string& fileID)
{
  std::filesystem::path path;
  std::istringstream parts(fileID);
  for (std::string part; std::getline(parts, part, '\\');)
  {
    path /= std::filesystem::u8path(part);
  }
  return path;
}

// A medium must not lead to files that are not on it.
bool IsWithin(const std::filesystem::path& path)
{
  return path.is_relative() && !path.empty() &&
    std::find(path.begin(), path.end(), "..") == path.end();
}

}

std::vector<std::filesystem::path> ReadDicomDirectory(const std::filesystem::path& path)
{
  gdcm::Reader reader;
  const DicomStream stream(path, reader);
  if (!reader.Read())
  {
    throw VolumeReadingError("it is no DICOMDIR or is damaged");
  }
  const DicomDataSet data(reader.GetFile().GetDataSet());
  const auto records = data.Items(DicomTags::DirectoryRecordSequence);
  std::vector<std::filesystem::path> files;
  for (std::size_t index = 0; index < records.Size(); ++index)
  {
    const std::filesystem::path file =
      ToPath(records.Item(index).Text(DicomTags::ReferencedFileID));
    if (IsWithin(file))
    {
      files.push_back(path.parent_path() / file);
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}
