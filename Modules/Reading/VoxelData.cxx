#include "VoxelData.h"

#include "ByteStream.h"
#include "ScalarTypes.h"
#include "TextVoxels.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"
#include "VoxelArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

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
  if (files == 0 || share.voxels % files != 0)
  {
    throw VolumeReadingError(
      share.words + " cannot be spread evenly over " + std::to_string(files) + " files");
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
  switch (data.encoding)
  {
    case VoxelEncoding::Raw:
      if (present != expected || offset > size)
      {
        throw VolumeReadingError(
          found + " need exactly " + std::to_string(Sum(offset, expected)) + " bytes");
      }
      break;
    case VoxelEncoding::Compressed:
      if (present == 0 || (expected - 1) / LargestCompression >= present)
      {
        throw VolumeReadingError(
          found + " need more, even compressed: " + std::to_string(expected) + " bytes before it");
      }
      break;
    case VoxelEncoding::Text:
      // A digit and a blank for each voxel; the last one needs no blank.
      if (share.voxels > present / 2 + 1)
      {
        throw VolumeReadingError(found + " as text need more");
      }
      break;
  }
}

void ReadBinary(ByteStream& stream, const VoxelData& data, const Share& share, char* destination)
{
  stream.Skip(data.offsetInStream);
  const std::uint64_t present = stream.Read(destination, share.bytes);
  if (present < share.bytes)
  {
    throw VolumeReadingError("its voxels end after " + std::to_string(present) + " bytes, but " +
      share.words + " need " + std::to_string(share.bytes));
  }
  // This looks beyond the last voxel also to have the checksum of compressed data compared.
  char following = 0;
  if (data.bytesAfter == 0 && stream.Read(&following, 1) > 0)
  {
    throw VolumeReadingError("its data goes on after the " + std::to_string(share.bytes) +
      " bytes that " + share.words + " need");
  }
}

void ReadFile(
  const std::filesystem::path& file, const VoxelData& data, const Share& share, char* destination)
{
  const std::uint64_t offset = OffsetIn(SizeOfFile(file), data, share);
  const auto stream = OpenBytes(file, offset, data.encoding == VoxelEncoding::Compressed);
  if (data.encoding == VoxelEncoding::Text)
  {
    ReadTextVoxels(*stream, data.scalarType, share.voxels, destination);
    return;
  }
  ReadBinary(*stream, data, share, destination);
  SwapToMachine(destination, share.voxels, share.bytes / share.voxels, data.bigEndian);
}

}

vtkSmartPointer<vtkImageData> ReadVoxels(
  const VolumeGeometry& geometry, const VoxelData& data, std::vector<std::string>& warnings)
{
  CheckGeometry(geometry);
  const Share share = SharePerFile(geometry, data);
  for (const auto& file : data.files)
  {
    CheckSize(file, data, share);
  }
  auto voxels = AllocateVoxels(data.scalarType, share.voxels * data.files.size());
  char* destination = static_cast<char*>(voxels->GetVoidPointer(0));
  for (const auto& file : data.files)
  {
    ReadFile(file, data, share, destination);
    destination += share.bytes;
  }
  const bool rescales = data.slope != 1.0 || data.intercept != 0.0;
  voxels =
    rescales ? Rescaled(voxels, data.slope, data.intercept) : WithoutLongIntegers(voxels, warnings);
  voxels->SetName("scalars");
  auto image = vtkSmartPointer<vtkImageData>::New();
  ApplyGeometry(geometry, image);
  image->GetPointData()->SetScalars(voxels);
  return image;
}

}
