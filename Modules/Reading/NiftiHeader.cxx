#include "NiftiHeader.h"

#include "ByteStream.h"
#include "VolumeReadingError.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace penumbra
{

namespace
{

constexpr std::size_t Size1 = 348;
constexpr std::size_t Size2 = 540;

class HeaderBytes
{
public:
  HeaderBytes(const std::array<unsigned char, Size2>& bytes, bool bigEndian)
    : Bytes(bytes)
    , BigEndian(bigEndian)
  {
  }

  template <typename Value>
  Value At(std::size_t position) const
  {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Value); ++i)
    {
      const std::size_t place = this->BigEndian ? i : sizeof(Value) - 1 - i;
      bits = bits << 8 | this->Bytes[position + place];
    }
    return FromBits<Value>(bits);
  }

  template <typename Value, typename Values>
  void Fill(std::size_t position, Values& values) const
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = this->At<Value>(position + i * sizeof(Value));
    }
  }

private:
  template <typename Value>
  static Value FromBits(std::uint64_t bits)
  {
    Value value;
    if constexpr (sizeof(Value) == 2)
    {
      const auto ownBits = static_cast<std::uint16_t>(bits);
      std::memcpy(&value, &ownBits, sizeof(Value));
    }
    else if constexpr (sizeof(Value) == 4)
    {
      const auto ownBits = static_cast<std::uint32_t>(bits);
      std::memcpy(&value, &ownBits, sizeof(Value));
    }
    else
    {
      std::memcpy(&value, &bits, sizeof(Value));
    }
    return value;
  }

  const std::array<unsigned char, Size2>& Bytes;
  bool BigEndian;
};

NiftiHeader Version1(const HeaderBytes& bytes)
{
  NiftiHeader header;
  bytes.Fill<std::int16_t>(40, header.dim);
  header.datatype = bytes.At<std::int16_t>(70);
  header.bitpix = bytes.At<std::int16_t>(72);
  bytes.Fill<float>(76, header.pixdim);
  header.vox_offset = bytes.At<float>(108);
  header.scl_slope = bytes.At<float>(112);
  header.scl_inter = bytes.At<float>(116);
  header.qform_code = bytes.At<std::int16_t>(252);
  header.sform_code = bytes.At<std::int16_t>(254);
  bytes.Fill<float>(256, header.quatern);
  bytes.Fill<float>(268, header.qoffset);
  for (std::size_t row = 0; row < 3; ++row)
  {
    bytes.Fill<float>(280 + 16 * row, header.srow[row]);
  }
  header.size = Size1;
  return header;
}

NiftiHeader Version2(const HeaderBytes& bytes)
{
  NiftiHeader header;
  header.datatype = bytes.At<std::int16_t>(12);
  header.bitpix = bytes.At<std::int16_t>(14);
  bytes.Fill<std::int64_t>(16, header.dim);
  bytes.Fill<double>(104, header.pixdim);
  header.vox_offset = static_cast<double>(bytes.At<std::int64_t>(168));
  header.scl_slope = bytes.At<double>(176);
  header.scl_inter = bytes.At<double>(184);
  header.qform_code = bytes.At<std::int32_t>(344);
  header.sform_code = bytes.At<std::int32_t>(348);
  bytes.Fill<double>(352, header.quatern);
  bytes.Fill<double>(376, header.qoffset);
  for (std::size_t row = 0; row < 3; ++row)
  {
    bytes.Fill<double>(400 + 32 * row, header.srow[row]);
  }
  header.size = Size2;
  return header;
}

void ReadExactly(ByteStream& stream, unsigned char* destination, std::size_t size)
{
  if (stream.Read(destination, size) < size)
  {
    throw VolumeReadingError("its header is cut short; a NIfTI header has 348 or 540 bytes");
  }
}

}

NiftiHeader ReadNiftiHeader(ByteStream& stream)
{
  std::array<unsigned char, Size2> bytes{};
  ReadExactly(stream, bytes.data(), Size1);
  for (const bool bigEndian : { false, true })
  {
    const HeaderBytes ordered(bytes, bigEndian);
    const auto size = ordered.At<std::int32_t>(0);
    if (size == Size1 && std::memcmp(&bytes[344], "n+1", 4) == 0)
    {
      NiftiHeader header = Version1(ordered);
      header.bigEndian = bigEndian;
      return header;
    }
    if (size == Size2 && std::memcmp(&bytes[4], "n+2\0\r\n\x1a\n", 8) == 0)
    {
      ReadExactly(stream, &bytes[Size1], Size2 - Size1);
      NiftiHeader header = Version2(ordered);
      header.bigEndian = bigEndian;
      return header;
    }
    if (size == Size1 && std::memcmp(&bytes[344], "ni1", 4) == 0)
    {
      throw VolumeReadingError(
        "its voxels are in a file of their own (.hdr and .img); a NIfTI file "
        "that holds both is needed");
    }
  }
  throw VolumeReadingError("its header is not that of NIfTI-1 or NIfTI-2");
}

}
