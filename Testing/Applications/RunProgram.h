/**
 * @file RunProgram.h
 * @brief Programs of this project, run as a user runs them.
 */
#ifndef RunProgram_h
#define RunProgram_h

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra
{
struct ProgramResult
{
  /// -1 where the program did not end by itself.
  int exitStatus = -1;
  std::string output;
  std::string error;
};

ProgramResult RunPenumbraRender(const std::vector<std::string>& arguments);

/// A new, empty folder that is removed with all that is in it.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string PathOf(const std::string& name) const;
  std::string Write(const std::string& name, const std::string& content) const;
  std::vector<std::string> Names() const;

private:
  std::filesystem::path Path;
};

std::string ReadAll(const std::string& file);
}

#endif
