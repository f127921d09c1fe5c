/**
 * @file RunProgram.h
 * @brief Programs of this project, run as a user runs them.
 */
#ifndef RunProgram_h
#define RunProgram_h

#include "TemporaryFolder.h"

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

/// The first word of the command is the program.
ProgramResult RunProgram(const std::vector<std::string>& command);

ProgramResult RunPenumbraRender(const std::vector<std::string>& arguments);

std::string ReadAll(const std::string& file);

/// As a message on stderr is to be.
bool IsOneLine(const std::string& text);
}

#endif
