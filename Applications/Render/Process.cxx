#include "Process.h"

#ifdef _WIN32

#define PSAPI_VERSION 2
#include <io.h>
#include <stdio.h>
#include <windows.h>
// needs windows.h before it
#include <psapi.h>

namespace penumbra
{
namespace
{
double ToSeconds(const FILETIME& time)
{
  ULARGE_INTEGER ticks;
  ticks.LowPart = time.dwLowDateTime;
  ticks.HighPart = time.dwHighDateTime;
  return static_cast<double>(ticks.QuadPart) * 1e-7;
}
}

//------------------------------------------------------------------------------
double ProcessorSeconds()
{
  FILETIME created, ended, kernel, user;
  GetProcessTimes(GetCurrentProcess(), &created, &ended, &kernel, &user);
  return ToSeconds(kernel) + ToSeconds(user);
}

//------------------------------------------------------------------------------
std::uint64_t PeakMemoryBytes()
{
  PROCESS_MEMORY_COUNTERS counters = {};
  K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof(counters));
  return counters.PeakWorkingSetSize;
}

//------------------------------------------------------------------------------
bool IsTerminalAtStandardError()
{
  return _isatty(_fileno(stderr)) != 0;
}

}

#else

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>

namespace penumbra
{
namespace
{
rusage GetUsage()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double ToSeconds(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// What Linux tells of this program alone. 0 elsewhere.
std::uint64_t PeakResidentBytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string name; status >> name;)
  {
    if (name == "VmHWM:")
    {
      std::uint64_t kibibytes = 0;
      status >> kibibytes;
      return 1024 * kibibytes;
    }
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 0;
}
}

//------------------------------------------------------------------------------
double ProcessorSeconds()
{
  const rusage usage = GetUsage();
  return ToSeconds(usage.ru_utime) + ToSeconds(usage.ru_stime);
}

//------------------------------------------------------------------------------
std::uint64_t PeakMemoryBytes()
{
  // The usage below counts what the process held before it became this program: all of what
  // started it.
  if (const std::uint64_t peak = PeakResidentBytes())
  {
    return peak;
  }
#ifdef __APPLE__
  constexpr std::uint64_t unit = 1;
#else
  constexpr std::uint64_t unit = 1024;
#endif
  return static_cast<std::uint64_t>(GetUsage().ru_maxrss) * unit;
}

//------------------------------------------------------------------------------
bool IsTerminalAtStandardError()
{
  return isatty(STDERR_FILENO) != 0;
}

}

#endif
