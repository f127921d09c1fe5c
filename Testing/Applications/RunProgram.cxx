#include "RunProgram.h"

#include <vtksys/Process.h>

#include <fstream>
#include <iterator>
#include <memory>

namespace penumbra
{
ProgramResult RunProgram(const std::vector<std::string>& command)
{
  std::vector<const char*> words;
  for (const std::string& word : command)
  {
    words.push_back(word.c_str());
  }
  words.push_back(nullptr);
  const std::unique_ptr<vtksysProcess, decltype(&vtksysProcess_Delete)> process(
    vtksysProcess_New(), &vtksysProcess_Delete);
  vtksysProcess_SetCommand(process.get(), words.data());
  vtksysProcess_Execute(process.get());

  ProgramResult result;
  char* data = nullptr;
  int length = 0;
  while (const int pipe = vtksysProcess_WaitForData(process.get(), &data, &length, nullptr))
  {
    std::string& text = pipe == vtksysProcess_Pipe_STDERR ? result.error : result.output;
    text.append(data, static_cast<std::size_t>(length));
  }
  vtksysProcess_WaitForExit(process.get(), nullptr);
  if (vtksysProcess_GetState(process.get()) == vtksysProcess_State_Exited)
  {
    result.exitStatus = vtksysProcess_GetExitValue(process.get());
  }
  return result;
}

std::string ReadAll(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

bool IsOneLine(const std::string& text)
{
  return text.size() > 1 && text.find('\n') == text.size() - 1;
}
}
