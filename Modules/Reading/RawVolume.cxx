#include "FormatReaders.h"
#include "VolumeGeometry.h"
#include "VoxelData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>

namespace penumbra
{

Volume ReadRawVolume(
  const std::filesystem::path& path, const RawVolumeGeometry& raw, Warnings& warnings)
{
  const std::string name = ScalarTypeName(raw.scalarType);
  const std::optional<int> scalarType = ScalarTypeFromName(name);
  if (!scalarType)
  {
    throw VolumeReadingError(
      "its scalar type is " + name + "; one of " + ScalarTypeNames() + " is needed");
  }
  VolumeGeometry geometry;
  std::copy_n(raw.dimensions, 3, geometry.dimensions.begin());
  std::copy_n(raw.spacing, 3, geometry.spacing.begin());
  std::copy_n(raw.origin, 3, geometry.origin.begin());
  std::copy_n(raw.direction, 9, geometry.direction.begin());

  VoxelData data;
  data.files = { path };
  data.scalarType = *scalarType;
  data.bigEndian = raw.bigEndian;
  data.offset = raw.headerBytes;
  CheckVoxelData(geometry, data);
  return FinishedVolume(geometry, ReadUncompressed(geometry, data), warnings);
}

}
