/**
 * @file    ProgramArguments.h
 * @brief   the words of a command line, as all programs take them
 */

#ifndef ProgramArguments_h
#define ProgramArguments_h

namespace CLI
{
class App;
}

namespace penumbra
{

/// Parses the words. False where they ask for help or the version, which then have been printed.
/// Throws InputError where they are wrong.
bool ParseArguments(CLI::App& program, int argc, char* argv[]);

}

#endif
