/**
 * @class   VoxelData
 * @brief   where the voxels of a volume are and how they are written
 */

#ifndef VoxelData_h
#define VoxelData_h

#include "FileBytes.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
class vtkImageReader2;

namespace penumbra
{

class ReaderErrors;
struct VolumeGeometry;

struct VoxelData
{
  /// One, or one for each slice, in their order.
  std::vector<std::filesystem::path> files;
  /// Nothing: the voxels are not compressed.
  std::optional<CompressedFormat> compression;
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
};

/**
 * Throws VolumeReadingError where geometry and files do not match exactly or the voxels exceed the
 * memory of this machine. Sets the offset if it is not given.
 */
void CheckVoxelData(const VolumeGeometry& geometry, VoxelData& data);

/**
 * Throws VolumeReadingError where there is less memory than `bytes` in this machine.
 */
void CheckMemory(std::uint64_t bytes);

/**
 * Tells `reader` what would otherwise be a header's to tell.
 */
void SetUpReader(vtkImageReader2* reader, const VolumeGeometry& geometry, const VoxelData& data);

/**
 * Throws VolumeReadingError where the file that `reader` has read could not be read to the end.
 */
void CheckAllWasRead(vtkImageReader2* reader);

/**
 * Has `reader` read and returns its scalars. Throws VolumeReadingError where it or another object
 * observed by `errors` fails, or where the scalars are not `scalarType`, one per voxel.
 */
vtkSmartPointer<vtkDataArray> RunReader(
  vtkAlgorithm* reader, ReaderErrors& errors, const VolumeGeometry& geometry, int scalarType);

/**
 * The same by vtkImageReader2, for checked voxels that are not compressed.
 */
vtkSmartPointer<vtkDataArray> ReadUncompressed(
  const VolumeGeometry& geometry, const VoxelData& data);

/**
 * slope * v + intercept for every v of `voxels`: as float32 if that holds every value of their
 * type, else as float64.
 */
vtkSmartPointer<vtkDataArray> Rescaled(vtkDataArray* voxels, double slope, double intercept);

/**
 * The volume. Integers of 64 bits become float64, with a warning. A name for the scalars is given
 * where they are to keep it.
 */
vtkSmartPointer<vtkImageData> FinishedVolume(const VolumeGeometry& geometry,
  vtkSmartPointer<vtkDataArray> voxels, std::vector<std::string>& warnings,
  const std::string& name = "scalars");

}

#endif
