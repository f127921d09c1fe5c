#include "SharedArray.h"

#include "VolumeReadingError.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <map>
#include <mutex>
#include <utility>

namespace penumbra
{

namespace
{

// VTK tells no more than the address of what an array needs no longer.
class MemoryInUse
{
public:
  void Keep(SharedMemory memory)
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    void* const address = memory.GetData();
    this->ByAddress.emplace(address, std::move(memory));
  }

  void Release(void* address)
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    this->ByAddress.erase(address);
  }

private:
  std::mutex Access;
  std::map<void*, SharedMemory> ByAddress;
};

// Never destroyed: arrays of static objects may outlive it.
MemoryInUse& GetMemoryInUse()
{
  static auto* const memory = new MemoryInUse;
  return *memory;
}

void Release(void* address)
{
  GetMemoryInUse().Release(address);
}

template <typename Scalar>
vtkSmartPointer<vtkDataArray> MakeArray(SharedMemory memory, vtkIdType count)
{
  vtkSmartPointer<vtkDataArray> array =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(vtkTypeTraits<Scalar>::VTK_TYPE_ID));
  auto* const values = vtkAOSDataArrayTemplate<Scalar>::FastDownCast(array);
  auto* const data = reinterpret_cast<Scalar*>(memory.GetData());
  values->SetArray(data, count, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  values->SetArrayFreeFunction(Release);
  GetMemoryInUse().Keep(std::move(memory));
  return array;
}

}

vtkSmartPointer<vtkDataArray> MakeSharedArray(SharedMemory memory, int scalarType, vtkIdType count)
{
  const auto size = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(scalarType));
  if (size == 0 || memory.GetSize() / size < static_cast<std::size_t>(count))
  {
    throw VolumeReadingError("its voxels did not come back whole");
  }
  switch (scalarType)
  {
    vtkTemplateMacro(return MakeArray<VTK_TT>(std::move(memory), count));
    default:
      throw VolumeReadingError("its voxels came back with an unknown type");
  }
}

}
