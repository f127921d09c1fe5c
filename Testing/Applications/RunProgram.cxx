#include "RunProgram.h"

#include <vtksys/Process.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>

namespace penumbra
{
ProgramResult RunPenumbraRender(const std::vector<std::string>& arguments)
{
  std::vector<const char*> words = { PENUMBRA_RENDER };
  for (const std::string& argument : arguments)
  {
    words.push_back(argument.c_str());
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

TemporaryFolder::TemporaryFolder()
{
  std::random_device random;
  this->Path = std::filesystem::temp_directory_path() / ("penumbra " + std::to_string(random()));
  std::filesystem::create_directories(this->Path);
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Path, ignored);
}

std::string TemporaryFolder::PathOf(const std::string& name) const
{
  return (this->Path / name).string();
}

std::string TemporaryFolder::Write(const std::string& name, const std::string& content) const
{
  std::filesystem::create_directories((this->Path / name).parent_path());
  std::ofstream(this->Path / name, std::ios::binary) << content;
  return this->PathOf(name);
}

std::vector<std::string> TemporaryFolder::Names() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(this->Path))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string ReadAll(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}
}
