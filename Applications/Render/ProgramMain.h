/**
 * @file    ProgramMain.h
 * @brief   what the main functions of the programs have in common
 */

#ifndef ProgramMain_h
#define ProgramMain_h

#include <functional>

class vtkMessageCollector;

namespace penumbra
{

/**
 * Runs `task` and returns the program's exit status: 0 done; 2 where it throws InputError, for bad
 * input or usage; 1 where it throws anything else. The error is then one line on stderr, after the
 * name of the program. VTK's messages are collected meanwhile.
 */
int RunMain(const char* program, const std::function<void(vtkMessageCollector*)>& task);

}

#endif
