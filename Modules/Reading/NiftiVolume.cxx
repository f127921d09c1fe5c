#include "FormatReaders.h"
#include "NiftiHeader.h"
#include "ReaderErrors.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNIFTIImageHeader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace penumbra
{

namespace
{

// The number of volumes in time, of which the first is read.
std::int64_t TimeStepsOf(vtkNIFTIImageHeader* header)
{
  for (int axis = 5; axis <= header->GetDim(0); ++axis)
  {
    if (header->GetDim(axis) != 1)
    {
      throw VolumeReadingError("its axis " + std::to_string(axis) + " holds " +
        std::to_string(header->GetDim(axis)) + " values per voxel; one is needed");
    }
  }
  const std::int64_t steps = header->GetDim(0) >= 4 ? header->GetDim(4) : 1;
  if (steps < 1 || steps > std::numeric_limits<int>::max())
  {
    throw VolumeReadingError("its dim[4] is " + std::to_string(steps) +
      "; a number of steps in time, 1 or more, is needed");
  }
  return steps;
}

void PlaceBySform(vtkNIFTIImageHeader* header, VolumeGeometry& geometry)
{
  const double* const rows[3] = { header->GetSRowX(), header->GetSRowY(), header->GetSRowZ() };
  std::array<Vector3, 3> steps;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis][row] = rows[row][axis];
    }
    geometry.origin[row] = rows[row][3];
  }
  SetSteps(geometry, steps);
}

void PlaceByQform(vtkNIFTIImageHeader* header, VolumeGeometry& geometry)
{
  const double b = header->GetQuaternB();
  const double c = header->GetQuaternC();
  const double d = header->GetQuaternD();
  const double squares = b * b + c * c + d * d;
  // Rounding may make b, c and d longer than the unit quaternion that they are part of.
  const double length = std::max(1.0, std::sqrt(squares));
  const double quaternion[4] = { std::sqrt(std::max(0.0, 1.0 - squares)), b / length, c / length,
    d / length };
  double rotation[3][3];
  vtkMath::QuaternionToMatrix3x3(quaternion, rotation);
  const double mirror = header->GetPixDim(0) < 0.0 ? -1.0 : 1.0;
  std::array<Vector3, 3> steps;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      steps[axis][row] = rotation[row][axis] * geometry.spacing[axis] * (axis == 2 ? mirror : 1.0);
    }
  }
  geometry.origin = { header->GetQOffsetX(), header->GetQOffsetY(), header->GetQOffsetZ() };
  SetSteps(geometry, steps);
}

VolumeGeometry GeometryOf(vtkNIFTIImageHeader* header)
{
  VolumeGeometry geometry;
  for (int axis = 0; axis < 3 && axis < header->GetDim(0); ++axis)
  {
    geometry.dimensions[axis] = header->GetDim(axis + 1);
    geometry.spacing[axis] = header->GetPixDim(axis + 1);
  }
  if (header->GetSFormCode() > 0)
  {
    PlaceBySform(header, geometry);
    return geometry;
  }
  CheckGeometry(geometry);
  if (header->GetQFormCode() > 0)
  {
    PlaceByQform(header, geometry);
  }
  return geometry;
}

std::uint64_t OffsetOf(vtkNIFTIImageHeader* header)
{
  // Four bytes that announce extensions follow the header; writers that leave the offset at 0 mean
  // the byte after them.
  const std::int64_t least = (header->GetMagic()[2] == '1' ? NiftiSize1 : NiftiSize2) + 4;
  const std::int64_t offset = header->GetVoxOffset() == 0 ? least : header->GetVoxOffset();
  if (offset < least)
  {
    throw VolumeReadingError("its vox_offset is " + std::to_string(offset) + "; " +
      std::to_string(least) + " or more is needed");
  }
  return static_cast<std::uint64_t>(offset);
}

/**
 * Keeps the slices in the file's order, which vtkNIFTIImageReader reverses where the axes are
 * left-handed.
 */
class NiftiVoxelReader : public vtkNIFTIImageReader
{
public:
  static NiftiVoxelReader* New();
  vtkTypeMacro(NiftiVoxelReader, vtkNIFTIImageReader);

protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override
  {
    const int result = this->Superclass::RequestInformation(request, input, output);
    this->QFac = 1.0;
    if (this->HeaderSize == 0)
    {
      this->HeaderSize = static_cast<unsigned long>(OffsetOf(this->NIFTIHeader));
    }
    return result;
  }
};

vtkStandardNewMacro(NiftiVoxelReader);

// The standard: a slope of 0 says that nothing is to be scaled.
bool IsScaled(vtkNIFTIImageHeader* header)
{
  const double slope = header->GetSclSlope();
  if (slope == 0.0 || !std::isfinite(slope))
  {
    return false;
  }
  if (!std::isfinite(header->GetSclInter()))
  {
    throw VolumeReadingError(
      "its scl_inter is " + std::to_string(header->GetSclInter()) + "; a finite number is needed");
  }
  return slope != 1.0 || header->GetSclInter() != 0.0;
}

}

Volume ReadNiftiVolume(const std::filesystem::path& path, bool compressed, Warnings& warnings)
{
  VoxelData data;
  data.files = { path };
  data.scalarType = CheckNiftiHeader(path);
  ReaderErrors errors;
  vtkNew<NiftiVoxelReader> reader;
  errors.Observe(reader);
  errors.Observe(reader->GetExecutive());
  reader->SetFileName(path.u8string().c_str());
  reader->UpdateInformation();
  vtkNIFTIImageHeader* const header = reader->GetNIFTIHeader();
  const std::int64_t timeSteps = TimeStepsOf(header);
  const VolumeGeometry geometry = GeometryOf(header);
  const std::uint64_t offset = OffsetOf(header);
  if (compressed)
  {
    data.compression = CompressedFormat::Gzip;
  }
  (compressed ? data.offsetInStream : *data.offset) = offset;
  const bool isScaled = IsScaled(header);

  const std::uint64_t scalarSize = vtkDataArray::GetDataTypeSize(data.scalarType);
  const std::uint64_t bytes = NumberOfVoxels(geometry, scalarSize * timeSteps) * scalarSize;
  data.bytesAfter = bytes * static_cast<std::uint64_t>(timeSteps - 1);
  CheckVoxelData(geometry, data);
  if (timeSteps > 1)
  {
    warnings.push_back("of its " + std::to_string(timeSteps) + " steps in time the first is read");
  }
  auto voxels = RunReader(reader, errors, geometry, data.scalarType);
  if (isScaled)
  {
    voxels = Rescaled(voxels, header->GetSclSlope(), header->GetSclInter());
  }
  return FinishedVolume(geometry, voxels, warnings);
}

}
