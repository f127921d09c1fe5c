#include "SharedMemory.h"

#include "VolumeReadingError.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace penumbra
{

namespace
{

int MakeHandle()
{
#ifdef __linux__
  return memfd_create("penumbra", MFD_CLOEXEC);
#else
  const std::string name = "/penumbra-" + std::to_string(getpid());
  const int handle = shm_open(name.c_str(), O_CREAT | O_EXCL | O_RDWR, 0600);
  if (handle >= 0)
  {
    shm_unlink(name.c_str());
  }
  return handle;
#endif
}

}

SharedMemory::SharedMemory()
{
  // Away from the standard files, in whose place the child gets others.
  const int made = MakeHandle();
  this->Handle = made < 0 ? -1 : fcntl(made, F_DUPFD_CLOEXEC, HandleForChild + 1);
  const int error = errno;
  close(made);
  if (this->Handle < 0)
  {
    throw VolumeReadingError(
      std::string("shared memory for its voxels cannot be made: ") + std::strerror(error));
  }
}

SharedMemory::SharedMemory(int handle)
  : Handle(handle)
{
}

SharedMemory SharedMemory::OfParent()
{
  return SharedMemory(dup(HandleForChild)); // the next time it is there too
}

SharedMemory::~SharedMemory()
{
  this->Unmap();
  if (this->Handle >= 0)
  {
    close(this->Handle);
  }
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
  : Handle(std::exchange(other.Handle, -1))
  , Data(std::exchange(other.Data, nullptr))
  , Size(std::exchange(other.Size, 0))
{
}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept
{
  std::swap(this->Handle, other.Handle);
  std::swap(this->Data, other.Data);
  std::swap(this->Size, other.Size);
  return *this;
}

void SharedMemory::Resize(std::size_t size)
{
  this->Unmap();
  const bool isPossible = size <= static_cast<std::size_t>(std::numeric_limits<off_t>::max());
  if (!isPossible || ftruncate(this->Handle, static_cast<off_t>(size)) != 0)
  {
    throw std::bad_alloc();
  }
  this->Map();
}

void SharedMemory::Map()
{
  this->Unmap();
  struct stat status = {};
  if (fstat(this->Handle, &status) != 0)
  {
    throw std::bad_alloc();
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0)
  {
    return;
  }
  void* data = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, this->Handle, 0);
  if (data == MAP_FAILED)
  {
    throw std::bad_alloc();
  }
  this->Data = static_cast<char*>(data);
  this->Size = size;
}

void SharedMemory::Unmap()
{
  if (this->Data)
  {
    munmap(this->Data, this->Size);
    this->Data = nullptr;
    this->Size = 0;
  }
}

void LimitMemory(std::size_t bytes)
{
  rlimit memory = {};
  if (getrlimit(RLIMIT_AS, &memory) == 0)
  {
    memory.rlim_cur = memory.rlim_max == RLIM_INFINITY
      ? static_cast<rlim_t>(bytes)
      : std::min(memory.rlim_max, static_cast<rlim_t>(bytes));
    setrlimit(RLIMIT_AS, &memory);
  }
  const rlimit none = {};
  setrlimit(RLIMIT_CORE, &none);
}

}
