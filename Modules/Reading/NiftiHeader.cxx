#include "NiftiHeader.h"

#include "VolumeReadingError.h"
#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkType.h"
#include "vtk_zlib.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <string>

namespace penumbra
{

namespace
{

int ScalarTypeOf(std::int64_t datatype, std::int64_t bitpix)
{
  static const std::map<std::int64_t, int> types = { { 2, VTK_UNSIGNED_CHAR }, { 4, VTK_SHORT },
    { 8, VTK_INT }, { 16, VTK_FLOAT }, { 64, VTK_DOUBLE }, { 256, VTK_SIGNED_CHAR },
    { 512, VTK_UNSIGNED_SHORT }, { 768, VTK_UNSIGNED_INT }, { 1024, VTK_LONG_LONG },
    { 1280, VTK_UNSIGNED_LONG_LONG } };
  const auto type = types.find(datatype);
  if (type == types.end())
  {
    throw VolumeReadingError("its datatype is " + std::to_string(datatype) +
      "; a scalar type is needed: 2, 4, 8, 16, 64, 256, 512, 768, 1024 or 1280");
  }
  const int bits = 8 * vtkDataArray::GetDataTypeSize(type->second);
  if (bitpix != bits)
  {
    throw VolumeReadingError("its bitpix is " + std::to_string(bitpix) + ", but datatype " +
      std::to_string(datatype) + " has " + std::to_string(bits) + " bits");
  }
  return type->second;
}

class HeaderStart
{
public:
  explicit HeaderStart(const std::filesystem::path& path)
  {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(
      gzopen(path.u8string().c_str(), "rb"), gzclose);
    const int present = file ? gzread(file.get(), this->Bytes.data(), NiftiSize1) : -1;
    if (present < NiftiSize1)
    {
      throw VolumeReadingError(present < 0
          ? "its compressed data is damaged"
          : "its header is cut short; a NIfTI header has 348 or 540 bytes");
    }
    const auto size = this->At<std::int32_t>(0);
    this->Swaps = size != NiftiSize1 && size != NiftiSize2;
  }

  template <typename Value>
  Value At(std::size_t position) const
  {
    Value value;
    std::memcpy(&value, &this->Bytes[position], sizeof(Value));
    if (this->Swaps)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(Value));
    }
    return value;
  }

  bool Holds(std::size_t position, const char* bytes, std::size_t count) const
  {
    return std::memcmp(&this->Bytes[position], bytes, count) == 0;
  }

private:
  std::array<char, NiftiSize1> Bytes{};
  bool Swaps = false;
};

}

int CheckNiftiHeader(const std::filesystem::path& path)
{
  const HeaderStart start(path);
  const auto size = start.At<std::int32_t>(0);
  if (size == NiftiSize1 && start.Holds(344, "ni1", 4))
  {
    throw VolumeReadingError("its voxels are in a file of their own (.hdr and .img); a NIfTI file "
                             "that holds both is needed");
  }
  const bool isFirst = size == NiftiSize1 && start.Holds(344, "n+1", 4);
  if (!isFirst && (size != NiftiSize2 || !start.Holds(4, "n+2\0\r\n\x1a\n", 8)))
  {
    throw VolumeReadingError("its header is not that of NIfTI-1 or NIfTI-2");
  }
  const std::int64_t axes = isFirst ? start.At<std::int16_t>(40) : start.At<std::int64_t>(16);
  if (axes < 1 || axes > 7)
  {
    throw VolumeReadingError(
      "its dim[0] is " + std::to_string(axes) + "; a number of axes from 1 to 7 is needed");
  }
  const auto offset = start.At<float>(108);
  constexpr float largest = 9.0e15f;
  if (isFirst && !(std::abs(offset) < largest && offset == std::floor(offset)))
  {
    throw VolumeReadingError("its vox_offset is " + std::to_string(offset) + "; an integer from " +
      std::to_string(NiftiSize1 + 4) + " on is needed");
  }
  return ScalarTypeOf(
    start.At<std::int16_t>(isFirst ? 70 : 12), start.At<std::int16_t>(isFirst ? 72 : 14));
}

}
