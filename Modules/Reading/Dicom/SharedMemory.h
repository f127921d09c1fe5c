/**
 * @class   SharedMemory
 * @brief   memory that this process and one that it starts can both see
 *
 * It has no name in any file system and is gone with the last process that holds it.
 */

#ifndef SharedMemory_h
#define SharedMemory_h

#include <cstddef>
#include <string>

namespace penumbra
{

class SharedMemory
{
public:
  /**
   * New memory of size 0. Throws std::system_error.
   */
  SharedMemory();

  /**
   * The memory of the process that started this one, which is to call Map. Throws std::system_error
   * where `name` is not what GetName returned there.
   */
  explicit SharedMemory(const std::string& name);

  ~SharedMemory();
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /**
   * What the other process needs to find it.
   */
  std::string GetName() const;

  /**
   * Makes it `size` bytes large, zeros at first. Throws std::bad_alloc.
   */
  void Resize(std::size_t size);

  /**
   * Maps it as large as it is. Throws std::bad_alloc.
   */
  void Map();

  char* GetData() const { return this->Data; }
  std::size_t GetSize() const { return this->Size; }

private:
  void Unmap();

  int Handle = -1;
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
