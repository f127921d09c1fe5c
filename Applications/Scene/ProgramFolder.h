/**
 * @file    ProgramFolder.h
 * @brief   where the programs are installed
 */

#ifndef ProgramFolder_h
#define ProgramFolder_h

#include <filesystem>

namespace penumbra
{

/// The folder of the running program, whose main function got `argument` as its first one.
std::filesystem::path FolderOfProgram(const char* argument);

}

#endif
