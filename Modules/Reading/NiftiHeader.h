/**
 * @class   NiftiHeader
 * @brief   what the header of a NIfTI-1 or NIfTI-2 file says, https://nifti.nimh.nih.gov
 *
 * Names are those of the standard.
 */

#ifndef NiftiHeader_h
#define NiftiHeader_h

#include <array>
#include <cstdint>

namespace penumbra
{

class ByteStream;

struct NiftiHeader
{
  bool bigEndian = false;
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  std::int64_t datatype = 0;
  std::int64_t bitpix = 0;
  double vox_offset = 0.0;
  double scl_slope = 0.0;
  double scl_inter = 0.0;
  std::int64_t qform_code = 0;
  std::int64_t sform_code = 0;
  /// b, c and d.
  std::array<double, 3> quatern{};
  std::array<double, 3> qoffset{};
  std::array<std::array<double, 4>, 3> srow{};
  /// 348 or 540 bytes.
  std::uint64_t size = 0;
};

/**
 * Reads the header from the start of a file. Throws VolumeReadingError where it is not that of a
 * NIfTI file with header and voxels in one.
 */
NiftiHeader ReadNiftiHeader(ByteStream& stream);

}

#endif
