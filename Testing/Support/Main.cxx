#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

#include "PrepareTests.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

namespace
{
// The build lists the tests where there may be nothing to render with.
bool OnlyLists(int argc, char* argv[])
{
  return std::any_of(argv, argv + argc,
    [](const char* argument) { return std::string(argument).find("--list") == 0; });
}
}

int main(int argc, char* argv[])
{
  try
  {
    if (!OnlyLists(argc, argv))
    {
      penumbra::PrepareTests();
    }
    return Catch::Session().run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
