#include "StudyMachine.h"

#include <vtksys/SystemInformation.hxx>

namespace penumbra
{

nlohmann::ordered_json DescribeMachine()
{
  vtksys::SystemInformation machine;
  machine.RunCPUCheck();
  machine.RunOSCheck();
  machine.RunMemoryCheck();
  return { { "processor", machine.GetExtendedProcessorName() },
    { "processors", machine.GetNumberOfLogicalCPU() },
    { "memoryMiB", machine.GetTotalPhysicalMemory() }, { "system", machine.GetOSDescription() } };
}

}
