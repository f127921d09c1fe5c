/**
 * @file Catch.h
 * @brief Catch2, version 2 or 3, by one name: the test macros, generators, matchers and Approx.
 *
 * What only version 3 has by these names is given to version 2 here: SKIP("why") ends a test that
 * cannot run here, and Catch::Matchers::ContainsSubstring.
 */
#ifndef Catch_h
#define Catch_h

#if __has_include(<catch2/catch_test_macros.hpp>)

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>

using Catch::Approx;

#else

#include <catch2/catch.hpp>

#include <iostream>
#include <string>

namespace Catch
{
namespace Matchers
{
inline auto ContainsSubstring(const std::string& part)
{
  return Contains(part);
}
}
}

// ctest knows a skipped test by this word.
#define SKIP(why)                                                                                  \
  do                                                                                               \
  {                                                                                                \
    std::cout << "SKIPPED: " << why << std::endl;                                                  \
    return;                                                                                        \
  } while (false)

#endif

#endif
