#include "RunProgram.h"

namespace penumbra
{
ProgramResult RunPenumbraRender(const std::vector<std::string>& arguments)
{
  std::vector<std::string> command = { PENUMBRA_RENDER };
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunProgram(command);
}
}
