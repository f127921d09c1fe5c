/**
 * @class   VoxelData
 * @brief   where the voxels of a volume are and how they are written
 */

#ifndef VoxelData_h
#define VoxelData_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

struct VolumeGeometry;

enum class VoxelEncoding
{
  Raw,
  Compressed, ///< by zlib or gzip
  Text        ///< numbers separated by blanks
};

struct VoxelData
{
  /// In the order of the slices; each holds the same number of voxels.
  std::vector<std::filesystem::path> files;
  VoxelEncoding encoding = VoxelEncoding::Raw;
  /// Type in the file, as VTK's constant; may be VTK_LONG_LONG or VTK_UNSIGNED_LONG_LONG.
  int scalarType = VTK_UNSIGNED_CHAR;
  bool bigEndian = false;
  /// Bytes of each file before the voxels or their compressed stream. Nothing: the voxels are what
  /// the file ends with.
  std::optional<std::uint64_t> offset = 0;
  /// Bytes before the voxels within the compressed stream.
  std::uint64_t offsetInStream = 0;
  /// Bytes after the voxels, uncompressed, that rightly belong to the file.
  std::uint64_t bytesAfter = 0;
  /// A value v of the file stands for slope * v + intercept.
  double slope = 1.0;
  double intercept = 0.0;
};

/**
 * The volume. Throws VolumeReadingError where geometry and files do not match exactly, before it
 * asks for memory wherever the sizes alone tell.
 */
vtkSmartPointer<vtkImageData> ReadVoxels(
  const VolumeGeometry& geometry, const VoxelData& data, std::vector<std::string>& warnings);

}

#endif
