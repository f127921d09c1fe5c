#include "ChildProcess.h"

#include "VolumeReadingError.h"

namespace penumbra
{

namespace
{

std::mutex& GetMutex()
{
  static std::mutex mutex;
  return mutex;
}

}

ChildProcess::ChildProcess(const std::vector<std::string>& command)
  : OnlyOne(GetMutex())
  , Process(vtksysProcess_New())
{
  std::vector<const char*> arguments;
  for (const std::string& argument : command)
  {
    arguments.push_back(argument.c_str());
  }
  arguments.push_back(nullptr);
  vtksysProcess_SetCommand(this->Process, arguments.data());
  vtksysProcess_SetOption(this->Process, vtksysProcess_Option_HideWindow, 1);
  vtksysProcess_Execute(this->Process);
  if (vtksysProcess_GetState(this->Process) != vtksysProcess_State_Executing)
  {
    const std::string reason = vtksysProcess_GetErrorString(this->Process);
    vtksysProcess_Delete(this->Process);
    throw VolumeReadingError(
      "the program " + command.front() + " that parses it cannot be started: " + reason);
  }
}

ChildProcess::~ChildProcess()
{
  vtksysProcess_Kill(this->Process);
  vtksysProcess_WaitForExit(this->Process, nullptr);
  vtksysProcess_Delete(this->Process);
}

ChildProcess::Output ChildProcess::Wait(double seconds, std::string& bytes)
{
  char* data = nullptr;
  int length = 0;
  switch (vtksysProcess_WaitForData(this->Process, &data, &length, &seconds))
  {
    case vtksysProcess_Pipe_STDOUT:
      bytes.append(data, static_cast<std::size_t>(length));
      return Output::Some;
    case vtksysProcess_Pipe_STDERR: // what libraries say there is no answer
      return Output::Some;
    case vtksysProcess_Pipe_Timeout:
      return Output::NoneYet;
    default:
      return Output::Ended;
  }
}

}
