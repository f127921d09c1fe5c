#include "VoxelArray.h"

#include "VolumeReadingError.h"
#include "vtkByteSwap.h"
#include "vtkDataArray.h"

#include <vtksys/SystemInformation.hxx>

#include <cstdlib>

namespace penumbra
{

namespace
{

template <typename From, typename To>
void Rescale(const From* from, vtkIdType count, double slope, double intercept, To* to)
{
  for (vtkIdType voxel = 0; voxel < count; ++voxel)
  {
    to[voxel] = static_cast<To>(slope * static_cast<double>(from[voxel]) + intercept);
  }
}

template <typename To>
void RescaleTo(To* to, vtkDataArray* voxels, double slope, double intercept)
{
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(Rescale(static_cast<const VTK_TT*>(voxels->GetVoidPointer(0)),
      voxels->GetNumberOfTuples(), slope, intercept, to));
  }
}

}

vtkSmartPointer<vtkDataArray> AllocateVoxels(int scalarType, std::uint64_t count)
{
  const std::uint64_t bytes = count * vtkDataArray::GetDataTypeSize(scalarType);
  CheckMemory(bytes);
  // VTK's own allocation writes to stderr when it fails.
  void* const memory = std::malloc(bytes);
  if (memory == nullptr)
  {
    throw VolumeReadingError(
      "its voxels need " + std::to_string(bytes) + " bytes of memory, more than is free");
  }
  auto voxels = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
  voxels->SetVoidArray(
    memory, static_cast<vtkIdType>(count), 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return voxels;
}

void SwapToMachine(void* voxels, std::uint64_t count, std::uint64_t scalarSize, bool bigEndian)
{
  const std::uint16_t one = 1;
  const bool machineIsBigEndian = *reinterpret_cast<const unsigned char*>(&one) == 0;
  if (bigEndian != machineIsBigEndian)
  {
    vtkByteSwap::SwapVoidRange(voxels, count, scalarSize);
  }
}

vtkSmartPointer<vtkDataArray> Rescaled(vtkDataArray* voxels, double slope, double intercept)
{
  const std::uint64_t count = voxels->GetNumberOfTuples();
  if (voxels->GetDataType() == VTK_FLOAT || voxels->GetDataTypeSize() <= 2)
  {
    auto result = AllocateVoxels(VTK_FLOAT, count);
    RescaleTo(static_cast<float*>(result->GetVoidPointer(0)), voxels, slope, intercept);
    return result;
  }
  auto result = AllocateVoxels(VTK_DOUBLE, count);
  RescaleTo(static_cast<double*>(result->GetVoidPointer(0)), voxels, slope, intercept);
  return result;
}

vtkSmartPointer<vtkDataArray> WithoutLongIntegers(
  vtkDataArray* voxels, std::vector<std::string>& warnings)
{
  if (voxels->GetDataTypeSize() != 8 || voxels->GetDataType() == VTK_DOUBLE)
  {
    return voxels;
  }
  warnings.push_back("integers of 64 bits are read as float64, which is exact up to 2^53");
  return Rescaled(voxels, 1.0, 0.0);
}

void CheckMemory(std::uint64_t bytes)
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  const std::uint64_t mebibytes = machine.GetTotalPhysicalMemory();
  if (mebibytes > 0 && bytes / (1 << 20) > mebibytes)
  {
    throw VolumeReadingError("its voxels need " + std::to_string(bytes / (1 << 20)) +
      " MiB of memory, but this machine has " + std::to_string(mebibytes) + " MiB");
  }
}

}
