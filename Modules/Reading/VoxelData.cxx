#include "VoxelData.h"

#include "ReaderErrors.h"
#include "ScalarTypes.h"
#include "VolumeGeometry.h"
#include "VolumeReadingError.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace penumbra
{

namespace
{

std::array<int, 6> ExtentOf(const VolumeGeometry& geometry)
{
  std::array<int, 6> extent{};
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] = static_cast<int>(geometry.dimensions[axis] - 1);
  }
  return extent;
}

bool AreOfType(vtkDataArray* voxels, int scalarType)
{
  return std::string(ScalarTypeName(voxels->GetDataType())) == ScalarTypeName(scalarType);
}

}

void CheckAllWasRead(vtkImageReader2* reader)
{
  // vtkImageReader2 tells of a failure only by a warning that belongs to no object.
  if (reader->GetFile() != nullptr && !reader->GetFile()->good())
  {
    throw VolumeReadingError("reading its voxels failed; its disk may be damaged");
  }
}

void SetUpReader(vtkImageReader2* reader, const VolumeGeometry& geometry, const VoxelData& data)
{
  reader->SetDataScalarType(data.scalarType);
  reader->SetNumberOfScalarComponents(1);
  reader->SetFileDimensionality(data.files.size() > 1 ? 2 : 3);
  reader->SetDataExtent(ExtentOf(geometry).data());
  reader->SetHeaderSize(static_cast<unsigned long>(*data.offset));
  reader->FileLowerLeftOn();
  if (data.bigEndian)
  {
    reader->SetDataByteOrderToBigEndian();
  }
  else
  {
    reader->SetDataByteOrderToLittleEndian();
  }
}

vtkSmartPointer<vtkDataArray> RunReader(
  vtkAlgorithm* reader, ReaderErrors& errors, const VolumeGeometry& geometry, int scalarType)
{
  errors.Observe(reader);
  errors.Observe(reader->GetExecutive());
  reader->UpdateInformation();
  errors.ThrowIfAny();
  // A reader that understands a header otherwise must not allocate what was not checked.
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (static_cast<std::int64_t>(extent[2 * axis + 1]) - extent[2 * axis] + 1 !=
      geometry.dimensions[axis])
    {
      throw VolumeReadingError("its header is damaged: its dimensions can be read in two ways");
    }
  }
  reader->Update();
  errors.ThrowIfAny();
  auto* const image = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  vtkDataArray* const voxels = image ? image->GetPointData()->GetScalars() : nullptr;
  const std::uint64_t count = NumberOfVoxels(geometry, 1);
  if (voxels == nullptr || !AreOfType(voxels, scalarType) || voxels->GetNumberOfComponents() != 1 ||
    static_cast<std::uint64_t>(voxels->GetNumberOfTuples()) != count)
  {
    throw VolumeReadingError("it is damaged: VTK's reader does not find its " +
      std::to_string(count) + " voxels of " + ScalarTypeName(scalarType));
  }
  return voxels;
}

vtkSmartPointer<vtkDataArray> ReadUncompressed(
  const VolumeGeometry& geometry, const VoxelData& data)
{
  ReaderErrors errors;
  vtkNew<vtkImageReader2> reader;
  if (data.files.size() > 1)
  {
    vtkNew<vtkStringArray> names;
    for (const auto& file : data.files)
    {
      names->InsertNextValue(file.u8string());
    }
    reader->SetFileNames(names);
  }
  else
  {
    reader->SetFileName(data.files.front().u8string().c_str());
  }
  SetUpReader(reader, geometry, data);
  auto voxels = RunReader(reader, errors, geometry, data.scalarType);
  CheckAllWasRead(reader);
  return voxels;
}

vtkSmartPointer<vtkDataArray> Rescaled(vtkDataArray* voxels, double slope, double intercept)
{
  vtkSmartPointer<vtkDataArray> result;
  if (voxels->GetDataType() == VTK_FLOAT || voxels->GetDataTypeSize() <= 2)
  {
    result = vtkSmartPointer<vtkFloatArray>::New();
  }
  else
  {
    result = vtkSmartPointer<vtkDoubleArray>::New();
  }
  result->DeepCopy(voxels);
  const auto rescale = [&](auto* array)
  {
    for (auto&& value : vtk::DataArrayValueRange<1>(array))
    {
      value = static_cast<std::decay_t<decltype(value)>>(slope * value + intercept);
    }
  };
  if (auto* const floats = vtkFloatArray::SafeDownCast(result))
  {
    rescale(floats);
  }
  else
  {
    rescale(vtkDoubleArray::SafeDownCast(result));
  }
  return result;
}

vtkSmartPointer<vtkImageData> FinishedVolume(const VolumeGeometry& geometry,
  vtkSmartPointer<vtkDataArray> voxels, std::vector<std::string>& warnings, const std::string& name)
{
  if (voxels->GetDataTypeSize() == 8 && voxels->GetDataType() != VTK_DOUBLE)
  {
    warnings.push_back("integers of 64 bits are read as float64, which is exact up to 2^53");
    voxels = Rescaled(voxels, 1.0, 0.0);
  }
  voxels->SetName(name.c_str());
  auto image = vtkSmartPointer<vtkImageData>::New();
  ApplyGeometry(geometry, image);
  image->GetPointData()->SetScalars(voxels);
  return image;
}

}
