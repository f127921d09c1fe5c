/**
 * @file    VolumeFile.h
 * @brief   one function that reads a volume of any known format
 *
 * What comes back is one scalar per voxel as the active point scalars of a vtkImageData, whose
 * first voxel has the index (0, 0, 0), and the geometry that the file states: voxel (i, j, k) lies
 * at origin + direction * ((i, j, k) * spacing) in the file's own world and its own unit of length.
 *
 * - .raw: as given by RawVolumeGeometry.
 * - .mhd, .mha: MetaImage's own world (ITK writes LPS) by Offset and TransformMatrix, each row of
 *   whose list is the direction of one index axis.
 * - .nrrd, .nhdr: the file's own space (its field "space") by space origin and space directions;
 *   without these by spacings and axis mins.
 * - .nii, .nii.gz: NIfTI's RAS by the sform where its code is positive, else the qform where its
 *   code is positive, else pixdim alone.
 * - .vti: by Origin, Spacing and Direction.
 * - DICOM files, folders and DICOMDIRs: as vtkDICOMVolumeReader describes.
 *
 * No format is turned to another's world, so NIfTI's x and y point the other way than those of most
 * MetaImage files. The direction's columns are orthonormal (for .raw: as given); it may mirror.
 * Voxels keep the order of the file. Axes between two of which the cosine is more than 1e-3 (over
 * 256 voxels it moves one by a quarter of a voxel) are refused as sheared; less is taken for
 * rounding and made orthogonal.
 *
 * Scalars keep their type and value, NaN and infinity included, with two exceptions: 64-bit
 * integers become float64 (exact up to 2^53; a warning tells), and NIfTI's scl_slope and scl_inter
 * are applied, which gives float32, or float64 for types that float32 cannot hold.
 */

#ifndef VolumeFile_h
#define VolumeFile_h

#include "PenumbraReadingModule.h" // For export macro
#include "ScalarTypes.h"
#include "VolumeReadingError.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace penumbra
{

/**
 * What a .raw file does not say about itself.
 */
struct RawVolumeGeometry
{
  /// Number of voxels along x (fastest in the file), y and z, each 1 or more. Must be given.
  int dimensions[3] = { 0, 0, 0 };
  /// One of the eight types of ScalarTypes.h, as VTK's constant. Default: VTK_UNSIGNED_CHAR.
  int scalarType = VTK_UNSIGNED_CHAR;
  /// Distance between voxel centres, finite and more than 0. Default: 1.
  double spacing[3] = { 1.0, 1.0, 1.0 };
  /// Position of the first voxel's centre, finite. Default: 0.
  double origin[3] = { 0.0, 0.0, 0.0 };
  /// Directions of the index axes as the columns of a row-major matrix, finite and invertible; a
  /// mirroring one is allowed. Default: the identity.
  double direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  /// Whether the most significant byte of a voxel comes first. Default: false.
  bool bigEndian = false;
  /// Bytes before the first voxel. Header and voxels together must be the whole file. Default: 0.
  std::uint64_t headerBytes = 0;
};

/**
 * What else a reader is told. Formats that it does not concern ignore it.
 */
struct VolumeReadingOptions
{
  /// Needed for .raw.
  std::optional<RawVolumeGeometry> raw;
  /// Which series of a DICOM folder, by its Series Instance UID. Default: the largest.
  std::string series;
  /// The program penumbra-dicom-parser, for DICOM: files that GDCM crashes on do no harm then.
  /// Default: none, DICOM is parsed in this process.
  std::string dicomParser;
  /// Told now and then how much is done, 0 to 1; returns whether to go on. Default: none.
  std::function<bool(double)> progress;
};

/**
 * Reads the volume at `path` (UTF-8), whose extension, in any case, names its format: .raw, .mhd,
 * .mha, .nrrd, .nhdr, .nii, .nii.gz or .vti. Folders, and files of other names that start as DICOM
 * does, are read as DICOM. What a user should know about a volume that could be read is appended to
 * `warnings`, one line each.
 *
 * Throws VolumeReadingError, and nothing else, where the file is missing, unreadable, damaged,
 * longer or shorter than it says, named after another format, without exactly one scalar per voxel,
 * has a geometry that no volume can have, or where `progress` returns false. Sizes are checked
 * against the file before memory is asked for. Safe to call from several threads at once.
 */
PENUMBRAREADING_EXPORT vtkSmartPointer<vtkImageData> ReadVolumeFile(
  const std::string& path, const VolumeReadingOptions& options, std::vector<std::string>& warnings);

}

#endif
