#include "LocalDicomParser.h"

#include "DicomDirectory.h"
#include "DicomHeader.h"
#include "DicomVoxels.h"
#include "FailureReason.h"
#include "vtkDataArray.h"

#include <exception>

namespace penumbra
{

DicomHeaderResult TryReadDicomHeader(const std::filesystem::path& path)
{
  try
  {
    return ReadDicomHeader(path);
  }
  catch (const std::exception& error)
  {
    return FailureReason(error);
  }
}

std::vector<DicomHeaderResult> LocalDicomParser::ReadHeaders(
  const std::vector<std::filesystem::path>& paths, const ReadingProgress& progress)
{
  std::vector<DicomHeaderResult> results;
  for (const auto& path : paths)
  {
    if (!progress(static_cast<double>(results.size()) / static_cast<double>(paths.size())))
    {
      throw ReadingCancelled();
    }
    results.push_back(TryReadDicomHeader(path));
  }
  return results;
}

std::vector<std::filesystem::path> LocalDicomParser::ReadDirectory(
  const std::filesystem::path& path)
{
  return ReadDicomDirectory(path);
}

DicomVoxelArray LocalDicomParser::ReadVoxels(
  const std::vector<DicomFile>& files, const DicomVolumePlan& plan, const ReadingProgress& progress)
{
  vtkSmartPointer<vtkDataArray> voxels;
  const auto room = [&voxels, &plan](int scalarType)
  {
    voxels.TakeReference(vtkDataArray::CreateDataArray(scalarType));
    voxels->SetNumberOfTuples(static_cast<vtkIdType>(NumberOfVoxels(plan.geometry, 1)));
    return voxels->GetVoidPointer(0);
  };
  const auto start = [&progress](std::size_t, double fraction)
  {
    if (!progress(fraction))
    {
      throw ReadingCancelled();
    }
  };
  const DicomVoxels read = ReadDicomVoxels(files, plan, room, { start, false });
  return { voxels, read.filled };
}

}
