#include "XmlVoxelChecks.h"

#include "FileBytes.h"
#include "HeaderText.h"
#include "ScalarTypes.h"
#include "VolumeReadingError.h"
#include "vtkBase64Utilities.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace penumbra
{

namespace
{

constexpr std::uint64_t ChunkSize = 1 << 16;

[[noreturn]] void ThrowTooShort()
{
  throw VolumeReadingError("its voxels end too early; the file is cut short or damaged");
}

// How many bytes of the file `bytes` bytes take.
std::uint64_t WrittenSize(const XmlVoxels& voxels, std::uint64_t bytes)
{
  return voxels.isBase64 ? (bytes + 2) / 3 * 4 : bytes;
}

void CheckPresent(const XmlVoxels& voxels, std::uint64_t begin, std::uint64_t bytes)
{
  const std::uint64_t end = begin + WrittenSize(voxels, bytes);
  if (end > voxels.end)
  {
    ThrowTooShort();
  }
  for (std::uint64_t position = begin; voxels.isBase64 && position < end; position += ChunkSize)
  {
    for (const char letter : ReadBytes(voxels.file, position, std::min(ChunkSize, end - position)))
    {
      const bool isBase64 = (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z') ||
        (letter >= '0' && letter <= '9') || letter == '+' || letter == '/' || letter == '=';
      if (!isBase64)
      {
        throw VolumeReadingError("its voxels are damaged: they are not all base64 text");
      }
    }
  }
}

// The first numbers of the voxels, which announce what follows.
std::vector<std::uint64_t> ReadNumbers(const XmlVoxels& voxels, std::uint64_t count)
{
  const std::uint64_t size = count * voxels.headerSize;
  CheckPresent(voxels, voxels.begin, size);
  std::string bytes = ReadBytes(voxels.file, voxels.begin, WrittenSize(voxels, size));
  if (voxels.isBase64)
  {
    std::string decoded(bytes.size(), '\0');
    decoded.resize(
      vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(bytes.data()),
        bytes.size(), reinterpret_cast<unsigned char*>(decoded.data()), decoded.size()));
    bytes = decoded;
  }
  if (bytes.size() < size)
  {
    ThrowTooShort();
  }
  std::vector<std::uint64_t> numbers(count, 0);
  for (std::uint64_t i = 0; i < size; ++i)
  {
    const std::uint64_t number = i / voxels.headerSize;
    const std::uint64_t place = i % voxels.headerSize;
    const std::uint64_t shift = voxels.bigEndian ? voxels.headerSize - 1 - place : place;
    numbers[number] |= std::uint64_t(static_cast<unsigned char>(bytes[i])) << (8 * shift);
  }
  return numbers;
}

void CheckBlocks(const XmlVoxels& voxels, std::uint64_t bytes)
{
  const std::uint64_t present = voxels.end - voxels.begin;
  const auto start = ReadNumbers(voxels, 3);
  const std::uint64_t count = start[0];
  const std::uint64_t size = start[1];
  const std::uint64_t lastSize = start[2] > 0 ? start[2] : size;
  // In this order nothing can overflow.
  const std::uint64_t full = count - 1;
  const bool possible = count > 0 && count <= present / voxels.headerSize && lastSize <= size &&
    lastSize > 0 && lastSize <= bytes && (full == 0 || size <= bytes / full) &&
    full * size + lastSize == bytes;
  if (!possible)
  {
    throw VolumeReadingError("its compressed voxels are damaged: their blocks do not add up to " +
      std::to_string(bytes) + " bytes");
  }
  const auto numbers = ReadNumbers(voxels, 3 + count);
  std::uint64_t compressed = 0;
  for (std::uint64_t block = 3; block < numbers.size(); ++block)
  {
    if (numbers[block] > present - std::min(compressed, present))
    {
      throw VolumeReadingError("its compressed voxels are damaged: a block exceeds the file");
    }
    compressed += numbers[block];
  }
  CheckPresent(
    voxels, voxels.begin + WrittenSize(voxels, numbers.size() * voxels.headerSize), compressed);
}

void CheckWord(const std::string& word, int scalarType)
{
  const double number = ToNumber(word, "a voxel");
  if (scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE)
  {
    return;
  }
  if (!(number >= vtkDataArray::GetDataTypeMin(scalarType) &&
        number <= vtkDataArray::GetDataTypeMax(scalarType)) ||
    number != std::floor(number))
  {
    throw VolumeReadingError(
      "a voxel is \"" + word + "\"; a number of type " + ScalarTypeName(scalarType) + " is needed");
  }
}

void CheckText(const XmlVoxels& voxels, int scalarType, std::uint64_t count)
{
  // No number is written longer than this.
  constexpr std::size_t longestWord = 100;
  std::uint64_t found = 0;
  std::string rest;
  for (std::uint64_t position = voxels.begin; position < voxels.end; position += ChunkSize)
  {
    rest += ReadBytes(voxels.file, position, std::min(ChunkSize, voxels.end - position));
    const bool isLast = position + ChunkSize >= voxels.end;
    const std::size_t last = rest.find_last_of(" \t\r\n");
    const std::size_t whole = isLast ? rest.size() : last == std::string::npos ? 0 : last;
    for (const std::string& word : Words(rest.substr(0, whole)))
    {
      CheckWord(word, scalarType);
      ++found;
    }
    rest.erase(0, whole);
    if (rest.size() > longestWord)
    {
      throw VolumeReadingError(
        "its voxels are \"" + rest.substr(0, longestWord) + "...\"; numbers in text are needed");
    }
  }
  if (found != count)
  {
    throw VolumeReadingError("its data holds " +
      (found > count ? "more than the " + std::to_string(count)
                     : std::to_string(found) + " of the " + std::to_string(count)) +
      " numbers that its header states");
  }
}

}

void CheckXmlVoxels(const XmlVoxels& voxels, int scalarType, std::uint64_t count)
{
  // The most that one byte can stand for: LZMA's, the densest of VTK's compressors.
  constexpr std::uint64_t largestCompression = 8192;
  const std::uint64_t present = voxels.end - voxels.begin;
  const std::uint64_t bytes = count * vtkDataArray::GetDataTypeSize(scalarType);
  const bool tooFew = voxels.isText ? count > present / 2 + 1
    : voxels.isCompressed           ? bytes / largestCompression > present
                                    : bytes > present;
  if (tooFew)
  {
    throw VolumeReadingError("it holds " + std::to_string(present) +
      " bytes where its voxels are, too few for " + std::to_string(count) + " voxels of " +
      ScalarTypeName(scalarType));
  }
  if (voxels.isText)
  {
    CheckText(voxels, scalarType, count);
    return;
  }
  if (voxels.isCompressed)
  {
    CheckBlocks(voxels, bytes);
    return;
  }
  const std::uint64_t announced = ReadNumbers(voxels, 1)[0];
  if (announced != bytes)
  {
    throw VolumeReadingError("its voxels are " + std::to_string(announced) + " bytes, but " +
      std::to_string(bytes) + " are needed");
  }
  CheckPresent(voxels, voxels.begin, voxels.headerSize + bytes);
}

std::uint64_t PositionOf(char letter, const std::filesystem::path& file, std::uint64_t begin)
{
  for (std::uint64_t position = begin;; position += ChunkSize)
  {
    const std::string bytes = ReadBytes(file, position, ChunkSize);
    const std::size_t found = bytes.find(letter);
    if (found != std::string::npos)
    {
      return position + found;
    }
    if (bytes.size() < ChunkSize)
    {
      ThrowTooShort();
    }
  }
}

}
