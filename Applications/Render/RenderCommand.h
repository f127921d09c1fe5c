/**
 * @file    RenderCommand.h
 * @brief   penumbra-render from its command to its files
 */

#ifndef RenderCommand_h
#define RenderCommand_h

#include "CommandLine.h"

class vtkMessageCollector;

namespace penumbra
{

/**
 * Reads, renders and writes as the command says, and prints warnings to stderr. Files appear only
 * if all went well.
 * @throw InputError where the input is not valid, RenderingError where rendering fails.
 */
void Execute(const RenderCommand& command, vtkMessageCollector* messages);

}

#endif
