/**
 * @class   ChildProcess
 * @brief   a program started by this one, and what it writes to its standard output
 *
 * There is one at a time, for KWSys keeps all of them in one place without a lock; the next one, of
 * another thread, waits.
 */

#ifndef ChildProcess_h
#define ChildProcess_h

#include "vtksys/Process.h"

#include <mutex>
#include <string>
#include <vector>

namespace penumbra
{

class ChildProcess
{
public:
  /**
   * Starts `command`, the path of a program and its arguments. Throws VolumeReadingError where it
   * cannot be started.
   */
  explicit ChildProcess(const std::vector<std::string>& command);

  /**
   * Ends the program if it still runs.
   */
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

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
  std::unique_lock<std::mutex> OnlyOne;
  vtksysProcess* Process;
};

}

#endif
