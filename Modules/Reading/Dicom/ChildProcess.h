/**
 * @class   ChildProcess
 * @brief   a program started by this one, with a connection to its standard input and output
 *
 * What it writes to its standard error is dropped. It ends with this object at the latest.
 */

#ifndef ChildProcess_h
#define ChildProcess_h

#include <string>
#include <vector>

namespace penumbra
{

class SharedMemory;

class ChildProcess
{
public:
  /**
   * Starts `command`, the path of a program and its arguments. It finds `memory` by
   * SharedMemory::OfParent. Throws VolumeReadingError where it cannot be started.
   */
  ChildProcess(const std::vector<std::string>& command, const SharedMemory& memory);

  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /**
   * Writes to its standard input. Returns false where it does not read any more.
   */
  bool Send(const std::string& bytes);

  enum class Output
  {
    Some,
    NoneYet,
    Ended
  };

  /**
   * Waits up to `seconds` for output and appends it to `bytes`.
   */
  Output Wait(double seconds, std::string& bytes);

private:
  int Connection = -1;
  int Process = -1;
};

}

#endif
