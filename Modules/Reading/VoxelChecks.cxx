#include "ScalarTypes.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"
#include "VoxelData.h"
#include "vtkDataArray.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <limits>

namespace penumbra
{

namespace
{

// What one byte of a deflated stream can stand for at most.
constexpr std::uint64_t LargestCompression = 1032;

/// What each of the files has to hold, in numbers and in words.
struct Share
{
  std::uint64_t voxels = 0;
  std::uint64_t bytes = 0;
  std::string words;
};

std::uint64_t Sum(std::uint64_t a, std::uint64_t b)
{
  const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
  return a > largest - b ? largest : a + b;
}

Share SharePerFile(const VolumeGeometry& geometry, const VoxelData& data)
{
  const std::uint64_t scalarSize = vtkDataArray::GetDataTypeSize(data.scalarType);
  Share share;
  share.voxels = NumberOfVoxels(geometry, scalarSize);
  share.words = std::to_string(geometry.dimensions[0]) + " x " +
    std::to_string(geometry.dimensions[1]) + " x " + std::to_string(geometry.dimensions[2]) +
    " voxels of " + ScalarTypeName(data.scalarType);
  const std::uint64_t files = data.files.size();
  if (files != 1 && files != static_cast<std::uint64_t>(geometry.dimensions[2]))
  {
    throw VolumeReadingError(share.words + " are spread over " + std::to_string(files) +
      " files; one file, or one for each slice, is needed");
  }
  share.voxels /= files;
  share.bytes = share.voxels * scalarSize;
  share.words += files > 1 ? " over " + std::to_string(files) + " files" : "";
  return share;
}

std::uint64_t OffsetIn(std::uint64_t fileSize, const VoxelData& data, const Share& share)
{
  return data.offset.value_or(fileSize > share.bytes ? fileSize - share.bytes : 0);
}

// Compares what `file` has to hold with its size alone.
void CheckSize(const std::filesystem::path& file, const VoxelData& data, const Share& share)
{
  const std::uint64_t size = SizeOfFile(file);
  const std::uint64_t offset = OffsetIn(size, data, share);
  const std::uint64_t present = size - std::min(offset, size);
  const std::uint64_t expected = Sum(Sum(share.bytes, data.offsetInStream), data.bytesAfter);
  const std::uint64_t header = Sum(offset, data.offsetInStream);
  const std::string found = "\"" + file.filename().u8string() + "\" holds " + std::to_string(size) +
    " bytes, but " +
    (header > 0 ? "a header of " + std::to_string(header) + " bytes and " : std::string()) +
    share.words;
  if (!data.compression && (present != expected || offset > size))
  {
    throw VolumeReadingError(
      found + " need exactly " + std::to_string(Sum(offset, expected)) + " bytes");
  }
  if (data.compression && (present == 0 || (expected - 1) / LargestCompression >= present))
  {
    throw VolumeReadingError(
      found + " need more, even compressed: " + std::to_string(expected) + " bytes before it");
  }
}

}

void CheckVoxelData(const VolumeGeometry& geometry, VoxelData& data)
{
  CheckGeometry(geometry);
  const Share share = SharePerFile(geometry, data);
  for (const auto& file : data.files)
  {
    CheckSize(file, data, share);
  }
  CheckMemory(share.bytes * data.files.size());
  data.offset = OffsetIn(SizeOfFile(data.files.front()), data, share);
  for (const auto& file : data.files)
  {
    if (data.compression)
    {
      CheckCompressed(
        file, *data.offset, *data.compression, share.bytes + data.offsetInStream + data.bytesAfter);
    }
  }
}

void CheckMemory(std::uint64_t bytes)
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  const std::uint64_t mebibytes = machine.GetTotalPhysicalMemory();
  if (mebibytes > 0 && bytes / (1 << 20) > mebibytes)
  {
    throw VolumeReadingError("its voxels need " + std::to_string(bytes / (1 << 20)) +
      " MiB of memory, but this machine has " + std::to_string(mebibytes) + " MiB");
  }
}

}
