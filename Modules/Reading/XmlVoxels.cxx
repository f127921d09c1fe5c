#include "XmlVoxels.h"

#include "Base64.h"
#include "ByteStream.h"
#include "ScalarTypes.h"
#include "TextVoxels.h"
#include "VolumeReadingError.h"
#include "VoxelArray.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

#include <utility>
#include <vector>

namespace penumbra
{

namespace
{

// The most that one byte can stand for: LZMA's, the densest of VTK's compressors.
constexpr std::uint64_t LargestCompression = 8192;

void ReadExactly(ByteStream& stream, void* destination, std::uint64_t size)
{
  if (stream.Read(destination, size) < size)
  {
    throw VolumeReadingError("its voxels end too early; the file is cut short or damaged");
  }
}

std::uint64_t ReadHeaderNumber(ByteStream& stream, const XmlVoxels& voxels)
{
  unsigned char bytes[8];
  ReadExactly(stream, bytes, voxels.headerSize);
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < voxels.headerSize; ++i)
  {
    number = number << 8 | bytes[voxels.bigEndian ? i : voxels.headerSize - 1 - i];
  }
  return number;
}

vtkSmartPointer<vtkDataCompressor> CreateCompressor(const std::string& name)
{
  if (name == "vtkZLibDataCompressor")
  {
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  }
  if (name == "vtkLZ4DataCompressor")
  {
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  }
  if (name == "vtkLZMADataCompressor")
  {
    return vtkSmartPointer<vtkLZMADataCompressor>::New();
  }
  throw VolumeReadingError("its compressor is \"" + name +
    "\"; vtkZLibDataCompressor, vtkLZ4DataCompressor or vtkLZMADataCompressor is needed");
}

/// The sizes of the blocks that compressed voxels are cut into.
struct Blocks
{
  std::uint64_t size = 0;
  std::uint64_t lastSize = 0;
  std::vector<std::uint64_t> compressedSizes;
};

Blocks ReadBlockSizes(ByteStream& stream, const XmlVoxels& voxels, std::uint64_t bytes)
{
  const std::uint64_t present = voxels.end - voxels.begin;
  const std::uint64_t count = ReadHeaderNumber(stream, voxels);
  Blocks blocks;
  blocks.size = ReadHeaderNumber(stream, voxels);
  const std::uint64_t partialSize = ReadHeaderNumber(stream, voxels);
  blocks.lastSize = partialSize > 0 ? partialSize : blocks.size;
  // A single block is a partial one, however large a full one would be. In this order nothing can
  // overflow.
  const std::uint64_t full = count - 1;
  const bool possible = count > 0 && count <= present / voxels.headerSize &&
    blocks.lastSize <= bytes && (full == 0 || blocks.size <= bytes / full) &&
    full * blocks.size + blocks.lastSize == bytes;
  if (!possible)
  {
    throw VolumeReadingError("its compressed voxels are damaged: their blocks do not add up to " +
      std::to_string(bytes) + " bytes");
  }
  for (std::uint64_t block = 0; block < count; ++block)
  {
    blocks.compressedSizes.push_back(ReadHeaderNumber(stream, voxels));
    if (blocks.compressedSizes.back() > present)
    {
      throw VolumeReadingError("its compressed voxels are damaged: a block exceeds the file");
    }
  }
  return blocks;
}

void ReadCompressed(
  ByteStream& stream, const XmlVoxels& voxels, std::uint64_t bytes, unsigned char* destination)
{
  const auto compressor = CreateCompressor(voxels.compressor);
  // An observed error does not go to stderr; what it means shows in the number of bytes.
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  compressor->AddObserver(vtkCommand::ErrorEvent, silence);

  const Blocks blocks = ReadBlockSizes(stream, voxels, bytes);
  std::vector<unsigned char> compressed;
  const std::size_t last = blocks.compressedSizes.size() - 1;
  for (std::size_t block = 0; block <= last; ++block)
  {
    const std::uint64_t size = block == last ? blocks.lastSize : blocks.size;
    compressed.resize(blocks.compressedSizes[block]);
    ReadExactly(stream, compressed.data(), compressed.size());
    if (compressor->Uncompress(compressed.data(), compressed.size(), destination, size) != size)
    {
      throw VolumeReadingError("its compressed voxels are damaged");
    }
    destination += size;
  }
}

void ReadUncompressed(
  ByteStream& stream, const XmlVoxels& voxels, std::uint64_t bytes, void* destination)
{
  const std::uint64_t announced = ReadHeaderNumber(stream, voxels);
  if (announced != bytes)
  {
    throw VolumeReadingError("its voxels are " + std::to_string(announced) + " bytes, but " +
      std::to_string(bytes) + " are needed");
  }
  ReadExactly(stream, destination, bytes);
}

}

void CheckSize(const XmlVoxels& voxels, int scalarType, std::uint64_t count)
{
  const std::uint64_t present = voxels.end - voxels.begin;
  const std::uint64_t bytes = count * vtkDataArray::GetDataTypeSize(scalarType);
  const bool tooFew = voxels.isText ? count > present / 2 + 1
    : voxels.compressor.empty()     ? bytes > present
                                    : bytes / LargestCompression > present;
  if (tooFew)
  {
    throw VolumeReadingError("it holds " + std::to_string(present) +
      " bytes where its voxels are, too few for " + std::to_string(count) + " voxels of " +
      ScalarTypeName(scalarType));
  }
}

void ReadXmlVoxels(const XmlVoxels& voxels, int scalarType, std::uint64_t count, void* destination)
{
  std::unique_ptr<ByteStream> stream = OpenPart(voxels.file, voxels.begin, voxels.end);
  if (voxels.isText)
  {
    ReadTextVoxels(*stream, scalarType, count, destination);
    return;
  }
  if (voxels.isBase64)
  {
    stream = DecodeBase64(std::move(stream));
  }
  const std::size_t scalarSize = vtkDataArray::GetDataTypeSize(scalarType);
  if (voxels.compressor.empty())
  {
    ReadUncompressed(*stream, voxels, count * scalarSize, destination);
  }
  else
  {
    ReadCompressed(*stream, voxels, count * scalarSize, static_cast<unsigned char*>(destination));
  }
  SwapToMachine(destination, count, scalarSize, voxels.bigEndian);
}

}
