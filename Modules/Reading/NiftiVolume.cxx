#include "ByteStream.h"
#include "FormatReaders.h"
#include "NiftiHeader.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace penumbra
{

namespace
{

int ScalarTypeOf(const NiftiHeader& header)
{
  static const std::map<std::int64_t, int> types = { { 2, VTK_UNSIGNED_CHAR }, { 4, VTK_SHORT },
    { 8, VTK_INT }, { 16, VTK_FLOAT }, { 64, VTK_DOUBLE }, { 256, VTK_SIGNED_CHAR },
    { 512, VTK_UNSIGNED_SHORT }, { 768, VTK_UNSIGNED_INT }, { 1024, VTK_LONG_LONG },
    { 1280, VTK_UNSIGNED_LONG_LONG } };
  const auto type = types.find(header.datatype);
  if (type == types.end())
  {
    throw VolumeReadingError("its datatype is " + std::to_string(header.datatype) +
      "; a scalar type is needed: 2, 4, 8, 16, 64, 256, 512, 768, 1024 or 1280");
  }
  const int bits = 8 * vtkDataArray::GetDataTypeSize(type->second);
  if (header.bitpix != bits)
  {
    throw VolumeReadingError("its bitpix is " + std::to_string(header.bitpix) + ", but datatype " +
      std::to_string(header.datatype) + " has " + std::to_string(bits) + " bits");
  }
  return type->second;
}

// The number of volumes in time, of which the first is read.
std::int64_t TimeStepsOf(const NiftiHeader& header)
{
  if (header.dim[0] < 1 || header.dim[0] > 7)
  {
    throw VolumeReadingError("its dim[0] is " + std::to_string(header.dim[0]) +
      "; a number of axes from 1 to 7 is needed");
  }
  for (std::int64_t axis = 5; axis <= header.dim[0]; ++axis)
  {
    if (header.dim[axis] != 1)
    {
      throw VolumeReadingError("its axis " + std::to_string(axis) + " holds " +
        std::to_string(header.dim[axis]) + " values per voxel; one is needed");
    }
  }
  const std::int64_t steps = header.dim[0] >= 4 ? header.dim[4] : 1;
  if (steps < 1 || steps > std::numeric_limits<int>::max())
  {
    throw VolumeReadingError("its dim[4] is " + std::to_string(steps) +
      "; a number of steps in time, 1 or more, is needed");
  }
  return steps;
}

void PlaceBySform(const NiftiHeader& header, VolumeGeometry& geometry)
{
  std::array<Vector3, 3> steps;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis][row] = header.srow[row][axis];
    }
    geometry.origin[row] = header.srow[row][3];
  }
  SetSteps(geometry, steps);
}

void PlaceByQform(const NiftiHeader& header, VolumeGeometry& geometry)
{
  const auto& [b, c, d] = header.quatern;
  const double squares = b * b + c * c + d * d;
  // Rounding may make b, c and d longer than the unit quaternion that they are part of.
  const double length = std::max(1.0, std::sqrt(squares));
  const double quaternion[4] = { std::sqrt(std::max(0.0, 1.0 - squares)), b / length, c / length,
    d / length };
  double rotation[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, rotation);
  const double mirror = header.pixdim[0] < 0.0 ? -1.0 : 1.0;
  std::array<Vector3, 3> steps;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis][row] = rotation[row][axis] * geometry.spacing[axis] * (axis == 2 ? mirror : 1.0);
    }
  }
  geometry.origin = header.qoffset;
  SetSteps(geometry, steps);
}

VolumeGeometry GeometryOf(const NiftiHeader& header)
{
  VolumeGeometry geometry;
  for (std::int64_t axis = 0; axis < 3 && axis < header.dim[0]; ++axis)
  {
    geometry.dimensions[axis] = header.dim[axis + 1];
    geometry.spacing[axis] = header.pixdim[axis + 1];
  }
  if (header.sform_code > 0)
  {
    PlaceBySform(header, geometry);
    return geometry;
  }
  CheckGeometry(geometry);
  if (header.qform_code > 0)
  {
    PlaceByQform(header, geometry);
  }
  return geometry;
}

std::uint64_t OffsetOf(const NiftiHeader& header)
{
  // Four bytes that announce extensions follow the header; writers that leave the offset at 0 mean
  // the byte after them.
  const double least = static_cast<double>(header.size) + 4.0;
  const double offset = header.vox_offset == 0.0 ? least : header.vox_offset;
  constexpr double largest = 9007199254740992.0; // 2^53: doubles are exact up to here
  if (!(offset >= least && offset <= largest) || offset != std::floor(offset))
  {
    throw VolumeReadingError("its vox_offset is " + std::to_string(offset) + "; an integer from " +
      std::to_string(header.size + 4) + " on is needed");
  }
  return static_cast<std::uint64_t>(offset);
}

void SetScaling(const NiftiHeader& header, VoxelData& data)
{
  // The standard: a slope of 0 says that nothing is to be scaled.
  if (header.scl_slope == 0.0 || !std::isfinite(header.scl_slope))
  {
    return;
  }
  if (!std::isfinite(header.scl_inter))
  {
    throw VolumeReadingError(
      "its scl_inter is " + std::to_string(header.scl_inter) + "; a finite number is needed");
  }
  data.slope = header.scl_slope;
  data.intercept = header.scl_inter;
}

}

Volume ReadNiftiVolume(const std::filesystem::path& path, bool compressed, Warnings& warnings)
{
  const NiftiHeader header = ReadNiftiHeader(*OpenBytes(path, 0, compressed));
  const std::int64_t timeSteps = TimeStepsOf(header);
  const VolumeGeometry geometry = GeometryOf(header);
  VoxelData data;
  data.files = { path };
  data.encoding = compressed ? VoxelEncoding::Compressed : VoxelEncoding::Raw;
  data.scalarType = ScalarTypeOf(header);
  data.bigEndian = header.bigEndian;
  (compressed ? data.offsetInStream : *data.offset) = OffsetOf(header);
  SetScaling(header, data);

  const std::uint64_t scalarSize = vtkDataArray::GetDataTypeSize(data.scalarType);
  const std::uint64_t bytes = NumberOfVoxels(geometry, scalarSize * timeSteps) * scalarSize;
  data.bytesAfter = bytes * static_cast<std::uint64_t>(timeSteps - 1);
  if (timeSteps > 1)
  {
    warnings.push_back("of its " + std::to_string(timeSteps) + " steps in time the first is read");
  }
  return ReadVoxels(geometry, data, warnings);
}

}
