#include "Catch.h"
#include "ReadDicom.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace fs = std::filesystem;

// Files that other programs wrote, as the package pydicom has them.

namespace
{

const fs::path Files = PENUMBRA_DICOM_FILES;

std::vector<std::string> Paths(bool folders)
{
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(Files))
  {
    if (entry.is_directory() == folders)
    {
      paths.push_back(entry.path().u8string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void CheckReadOrRefused(const std::string& path)
{
  INFO(path);
  const auto start = std::chrono::steady_clock::now();
  const auto reading = ReadDicom(path, PENUMBRA_DICOM_PARSER);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
  CHECK((reading.volume->GetNumberOfPoints() > 0) == reading.error.empty());
  const auto name = fs::u8path(path).filename().u8string();
  CHECK((reading.error.empty() || reading.error.find(name) != std::string::npos));
}

bool SameVoxels(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* const values = a->GetPointData()->GetScalars();
  vtkDataArray* const others = b->GetPointData()->GetScalars();
  bool same = values && others && values->GetNumberOfTuples() == others->GetNumberOfTuples();
  for (vtkIdType voxel = 0; same && voxel < values->GetNumberOfTuples(); ++voxel)
  {
    same = values->GetTuple1(voxel) == others->GetTuple1(voxel);
  }
  return same;
}

}

TEST_CASE("Each file that others wrote is read or refused in one line")
{
  if (!fs::exists(Files))
  {
    SKIP(Files << " is not installed");
  }
  for (const auto& path : Paths(false))
  {
    CheckReadOrRefused(path);
  }
}

TEST_CASE("Each folder that others wrote is read or refused in one line")
{
  if (!fs::exists(Files))
  {
    SKIP(Files << " is not installed");
  }
  for (const auto& path : Paths(true))
  {
    CheckReadOrRefused(path);
  }
}

TEST_CASE("An image that others encoded in several ways is the same")
{
  if (!fs::exists(Files))
  {
    SKIP(Files << " is not installed");
  }
  const auto read = [](const std::string& name)
  { return ReadDicom((Files / "test_files" / name).u8string(), PENUMBRA_DICOM_PARSER).volume; };
  const auto image = read("MR_small.dcm");
  CHECK(image->GetDimensions()[0] == 64);
  for (const char* name : { "MR_small_bigendian.dcm", "MR_small_expb.dcm", "MR_small_implicit.dcm",
         "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm", "MR_small_padded.dcm",
         "MR_small_RLE.dcm" })
  {
    INFO(name);
    CHECK(SameVoxels(read(name), image));
  }
}
