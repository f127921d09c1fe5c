#include "Catch.h"
#include "SampleVolume.h"

#include <cmath>
#include <limits>

using Catch::Matchers::ContainsSubstring;

namespace
{

const double NotANumber = std::nan("");
const double Infinity = std::numeric_limits<double>::infinity();

// What reading a file of 8 bytes as 2 x 2 x 2 voxels says once `change` has changed the geometry.
template <typename Change>
std::string FailureAfter(Change change)
{
  const TemporaryFolder folder;
  penumbra::RawVolumeGeometry geometry;
  geometry.dimensions[0] = geometry.dimensions[1] = geometry.dimensions[2] = 2;
  change(geometry);
  return FailureOf(folder.Write("a.raw", "12345678"), geometry);
}

}

TEST_CASE("Impossible RAW dimensions are refused before any memory is asked for")
{
  CHECK(FailureAfter([](auto&) {}) == "was read");
  const int impossible[][3] = { { 0, 2, 2 }, { 2, -1, 2 }, { 100000, 100000, 100000 },
    { 2147483647, 2147483647, 2147483647 }, { 65536, 65536, 65536 }, { -2, -2, 2 } };
  for (const auto& dimensions : impossible)
  {
    const auto failure = FailureAfter([&](auto& g) { std::copy_n(dimensions, 3, g.dimensions); });
    INFO(failure);
    CHECK_THAT(failure, ContainsSubstring("dimensions") || ContainsSubstring("need exactly"));
  }
  const auto wraps = FailureAfter(
    [](auto& g)
    {
      // 2^21 * 2^21 * 2^22 voxels would wrap to 0 in 64 bits.
      g.dimensions[0] = g.dimensions[1] = 1 << 21;
      g.dimensions[2] = 1 << 22;
    });
  CHECK_THAT(wraps, ContainsSubstring("dimensions"));
}

TEST_CASE("Impossible RAW spacing, origin, direction and type are refused by name")
{
  for (const double spacing : { 0.0, -1.0, NotANumber, Infinity })
  {
    CHECK_THAT(
      FailureAfter([&](auto& g) { g.spacing[1] = spacing; }), ContainsSubstring("spacing"));
  }
  for (const double origin : { NotANumber, Infinity, -Infinity })
  {
    CHECK_THAT(FailureAfter([&](auto& g) { g.origin[2] = origin; }), ContainsSubstring("origin"));
  }
  for (const double element : { 0.0, NotANumber, Infinity })
  {
    CHECK_THAT(
      FailureAfter([&](auto& g) { g.direction[4] = element; }), ContainsSubstring("direction"));
  }
  // The third row is the sum of the others.
  const double singular[9] = { 1, 2, 3, 4, 5, 6, 5, 7, 9 };
  CHECK_THAT(FailureAfter([&](auto& g) { std::copy_n(singular, 9, g.direction); }),
    ContainsSubstring("direction"));
  for (const int type : { VTK_LONG_LONG, VTK_STRING, -1, 12345 })
  {
    CHECK_THAT(FailureAfter([&](auto& g) { g.scalarType = type; }), ContainsSubstring("uint16"));
  }
}
