#include "Catch.h"
#include "InteractiveResolution.h"

using namespace penumbra;

TEST_CASE("A still has all rays, however long it takes")
{
  InteractiveResolution resolution;
  resolution.Measure(1.0, 100.0);
  CHECK(resolution.FindDistance(10000.0) == 1.0);
  CHECK(resolution.FindDistance(0.0) == 1.0);
  CHECK_FALSE(InteractiveResolution::IsInteractive(10000.0));
}

TEST_CASE("A moving picture has as many rays as fit into its time")
{
  InteractiveResolution resolution;
  CHECK(resolution.FindDistance(0.1) == 1.0);
  resolution.Measure(1.0, 0.4);
  CHECK(resolution.FindDistance(0.1) == 2.0);
  // The same frame, measured with a quarter of its rays.
  resolution.Measure(2.0, 0.1);
  CHECK(resolution.FindDistance(0.1) == 2.0);
  resolution.Measure(2.0, 0.02);
  CHECK(resolution.FindDistance(0.1) == 1.0);
}

TEST_CASE("However slow the frames, a moving picture shows what one moves")
{
  InteractiveResolution resolution;
  resolution.Measure(1.0, 1e6);
  CHECK(resolution.FindDistance(0.01) == InteractiveResolution::LargestDistance);
}
