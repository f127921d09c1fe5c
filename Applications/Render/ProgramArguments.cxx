#include "ProgramArguments.h"

#include "InputError.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace penumbra
{

//------------------------------------------------------------------------------
bool ParseArguments(CLI::App& program, int argc, char* argv[])
{
  try
  {
    program.parse(argc, argv);
  }
  catch (const CLI::Success& answer)
  {
    program.exit(answer, std::cout, std::cerr);
    return false;
  }
  catch (const CLI::ParseError& error)
  {
    throw InputError(
      std::string(error.what()) + "; " + program.get_name() + " --help tells the usage");
  }
  return true;
}

}
