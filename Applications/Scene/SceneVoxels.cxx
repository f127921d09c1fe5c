#include "SceneVolume.h"

#include "InputError.h"
#include "VolumeFile.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace penumbra
{
namespace
{
RawVolumeGeometry MakeRawGeometry(const VolumeDescription& volume)
{
  RawVolumeGeometry raw;
  const auto dimensions = volume.Dimensions.value_or(std::array<int, 3>{ 0, 0, 0 });
  std::copy(dimensions.begin(), dimensions.end(), raw.dimensions);
  raw.scalarType = volume.ScalarType.value_or(raw.scalarType);
  std::copy(volume.Spacing.begin(), volume.Spacing.end(), raw.spacing);
  std::copy(volume.Origin.begin(), volume.Origin.end(), raw.origin);
  std::copy(volume.Direction.begin(), volume.Direction.end(), raw.direction);
  raw.bigEndian = volume.BigEndian;
  raw.headerBytes = volume.HeaderBytes;
  return raw;
}

std::string DimensionsInWords(const int* dimensions)
{
  return std::to_string(dimensions[0]) + "x" + std::to_string(dimensions[1]) + "x" +
    std::to_string(dimensions[2]);
}

// VTK's mappers take masks of bytes that lie where the volume lies.
vtkSmartPointer<vtkImageData> ToMaskOf(vtkImageData* volume, vtkImageData* read)
{
  vtkDataArray* values = read->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> shown;
  shown->SetNumberOfTuples(values->GetNumberOfTuples());
  for (vtkIdType voxel = 0; voxel < values->GetNumberOfTuples(); ++voxel)
  {
    shown->SetValue(voxel, values->GetComponent(voxel, 0) != 0.0 ? 255 : 0);
  }
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(volume);
  mask->GetPointData()->SetScalars(shown);
  return mask;
}

// The reader knows the file, but not which key named it.
vtkSmartPointer<vtkImageData> ReadFileOfKey(const std::string& key,
  const std::filesystem::path& file, const VolumeReadingOptions& options,
  std::vector<std::string>& warnings)
{
  try
  {
    return ReadVolumeFile(file.u8string(), options, warnings);
  }
  catch (const VolumeReadingError& error)
  {
    throw InputError(key + ": " + error.what());
  }
}

VolumeReadingOptions MakeOptions(const VoxelReading& reading)
{
  VolumeReadingOptions options;
  options.dicomParser = reading.DicomParser.u8string();
  options.progress = reading.Progress;
  return options;
}

vtkSmartPointer<vtkImageData> ReadMask(const std::filesystem::path& file, vtkImageData* volume,
  const VoxelReading& reading, std::vector<std::string>& warnings)
{
  VolumeReadingOptions options = MakeOptions(reading);
  options.raw.emplace();
  std::copy_n(volume->GetDimensions(), 3, options.raw->dimensions);
  const auto mask = ReadFileOfKey("volume.mask", file, options, warnings);
  if (!std::equal(mask->GetDimensions(), mask->GetDimensions() + 3, volume->GetDimensions()))
  {
    throw InputError("volume.mask is " + file.u8string() + " with " +
      DimensionsInWords(mask->GetDimensions()) + " voxels; accepted: the volume's " +
      DimensionsInWords(volume->GetDimensions()));
  }
  return ToMaskOf(volume, mask);
}
}

//------------------------------------------------------------------------------
SceneVoxels ReadVoxels(
  const VolumeDescription& volume, const VoxelReading& reading, std::vector<std::string>& warnings)
{
  SceneVoxels voxels;
  VolumeReadingOptions options = MakeOptions(reading);
  options.raw = MakeRawGeometry(volume);
  options.series = volume.Series.value_or("");
  voxels.Volume = ReadFileOfKey("volume.file", volume.File, options, warnings);
  if (volume.Mask)
  {
    voxels.Mask = ReadMask(*volume.Mask, voxels.Volume, reading, warnings);
  }
  return voxels;
}

}
