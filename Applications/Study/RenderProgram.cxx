#include "RenderProgram.h"

#include <vtksys/Process.h>

#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;
using Process = std::unique_ptr<vtksysProcess, decltype(&vtksysProcess_Delete)>;

std::vector<std::string> CommandOf(const fs::path& program, const RenderRequest& request,
  const fs::path& picture, const fs::path& report)
{
  std::vector<std::string> command = { program.u8string(), request.Scene.u8string(), "--output",
    picture.u8string(), "--report", report.u8string() };
  for (const std::string& setting : request.Settings)
  {
    command.insert(command.end(), { "--set", setting });
  }
  if (request.Frames > 0)
  {
    command.insert(command.end(), { "--frames", std::to_string(request.Frames) });
  }
  return command;
}

// Returns what it wrote to stderr.
std::string Execute(vtksysProcess* process, const std::vector<std::string>& command, double limit)
{
  std::vector<const char*> words;
  for (const std::string& word : command)
  {
    words.push_back(word.c_str());
  }
  words.push_back(nullptr);
  vtksysProcess_SetCommand(process, words.data());
  vtksysProcess_SetTimeout(process, limit);
  vtksysProcess_Execute(process);
  std::string errors;
  char* data = nullptr;
  int length = 0;
  while (const int pipe = vtksysProcess_WaitForData(process, &data, &length, nullptr))
  {
    if (pipe == vtksysProcess_Pipe_STDERR)
    {
      errors.append(data, static_cast<std::size_t>(length));
    }
  }
  vtksysProcess_WaitForExit(process, nullptr);
  return errors;
}

RenderEnd EndOf(vtksysProcess* process)
{
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
    {
      constexpr int badInput = 2;
      const int status = vtksysProcess_GetExitValue(process);
      return status == 0 ? RenderEnd::Done
                         : (status == badInput ? RenderEnd::Refused : RenderEnd::Failed);
    }
    case vtksysProcess_State_Expired:
      return RenderEnd::TimedOut;
    case vtksysProcess_State_Exception:
      return RenderEnd::Crashed;
    default:
      return RenderEnd::Failed;
  }
}

std::string LastError(const std::string& errors)
{
  std::istringstream lines(errors);
  std::string last;
  for (std::string line; std::getline(lines, line);)
  {
    last = line.empty() || line.rfind("warning:", 0) == 0 ? last : line;
  }
  return last;
}
}

//------------------------------------------------------------------------------
RenderProgram::RenderProgram(fs::path program, fs::path workFolder)
  : Program(std::move(program))
  , WorkFolder(std::move(workFolder))
{
}

//------------------------------------------------------------------------------
RenderResult RenderProgram::Run(const RenderRequest& request) const
{
  const fs::path picture = this->WorkFolder / "picture.mha";
  const fs::path report = this->WorkFolder / "report.json";
  std::error_code ignored;
  fs::remove(picture, ignored);
  fs::remove(report, ignored);
  const Process process(vtksysProcess_New(), &vtksysProcess_Delete);
  RenderResult result;
  const std::string errors =
    Execute(process.get(), CommandOf(this->Program, request, picture, report), request.TimeLimit);
  result.End = EndOf(process.get());
  if (result.End != RenderEnd::Done)
  {
    result.Error = LastError(errors);
    return result;
  }
  result.Picture = ReadStudyPicture(picture);
  result.Report = nlohmann::json::parse(std::ifstream(report));
  return result;
}

//------------------------------------------------------------------------------
std::string NameOf(RenderEnd end)
{
  static const char* const names[] = { "done", "refused", "failed", "crashed", "timed out" };
  return names[static_cast<int>(end)];
}

}
