/**
 * @class   SharedMemory
 * @brief   memory that this process and one that it starts can both see
 *
 * It has no name in any file system and is gone with the last process that holds it.
 */

#ifndef SharedMemory_h
#define SharedMemory_h

#include <cstddef>

namespace penumbra
{

class SharedMemory
{
public:
  /**
   * New memory of size 0. Throws VolumeReadingError.
   */
  SharedMemory();

  /**
   * The memory that the process that started this one has given to it.
   */
  static SharedMemory OfParent();

  ~SharedMemory();
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  SharedMemory(const SharedMemory&) = delete;

  /**
   * The number of the file descriptor: here, and where a child finds what it is given.
   */
  int GetHandle() const { return this->Handle; }
  static constexpr int HandleForChild = 3;

  /**
   * Makes it `size` bytes large and maps it. Throws std::bad_alloc.
   */
  void Resize(std::size_t size);

  /**
   * Maps it as large as it is. Throws std::bad_alloc.
   */
  void Map();

  char* GetData() const { return this->Data; }
  std::size_t GetSize() const { return this->Size; }

private:
  explicit SharedMemory(int handle);
  void Unmap();

  int Handle;
  char* Data = nullptr;
  std::size_t Size = 0;
};

/**
 * Holds this process and those that it starts to so many bytes of memory from now on, and keeps it
 * from leaving its memory in a file when it crashes.
 */
void LimitMemory(std::size_t bytes);

}

#endif
