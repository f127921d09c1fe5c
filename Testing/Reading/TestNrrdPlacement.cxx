#include "Catch.h"
#include "SampleVolume.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

std::string Write(const TemporaryFolder& folder, const std::string& fields)
{
  return folder.Write("a.nrrd",
    "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 4 5\nendian: little\nencoding: raw\n" + fields +
      "\n" + SampleBytes<short>());
}

}

TEST_CASE("NRRD space directions and space origin place the volume in the file's own space")
{
  const TemporaryFolder folder;
  for (const char* space :
    { "space: left-posterior-superior\n", "space: RAS\n", "space: LAS\n", "space dimension: 3\n" })
  {
    INFO(space);
    const auto image = Read(Write(folder,
      std::string(space) +
        "space directions: (0,2,0) (0, 0, 3) (-4,0,0)\nspace origin: (10,20,30)\n"));
    CHECK(IsSample(image));
    CHECK(IsPlaced(image, { 10, 20, 30 }, { { { 0, 2, 0 }, { 0, 0, 3 }, { -4, 0, 0 } } }));
  }
}

TEST_CASE("NRRD directions may mirror and be oblique, but not sheared")
{
  const TemporaryFolder folder;
  const auto path = [&](const std::string& directions)
  { return Write(folder, "space: LPS\nspace directions: " + directions + "\n"); };
  CHECK(IsPlaced(Read(path("(3,4,0) (-4,3,0) (0,0,-1)")), { 0, 0, 0 },
    { { { 3, 4, 0 }, { -4, 3, 0 }, { 0, 0, -1 } } }));
  CHECK_THAT(FailureOf(path("(1,0,0) (0.1,1,0) (0,0,1)")), ContainsSubstring("sheared"));
  CHECK_THAT(FailureOf(path("(1,0,0) (0,1,0) (0,0,0)")), ContainsSubstring("axis 3"));
  CHECK_THAT(FailureOf(path("(1,0,0) (0,1,0) (0,0,nan)")), ContainsSubstring("axis 3"));
  CHECK_THAT(FailureOf(path("(1,0,0) (0,1,0)")), ContainsSubstring("space directions"));
  CHECK_THAT(FailureOf(path("1 0 0")), ContainsSubstring("list of vectors"));
  CHECK_THAT(FailureOf(path("(1,0,0,0) (0,1,0,0) (0,0,1,0)")), ContainsSubstring("dimensions"));
  CHECK_THAT(FailureOf(Write(folder, "space origin: (1,2,nan)\n")), ContainsSubstring("origin"));
}

TEST_CASE("Without directions NRRD spacings and axis mins place the volume")
{
  const TemporaryFolder folder;
  CHECK(IsPlaced(Read(Write(folder, "spacings: 2 3 4\n")), { 0, 0, 0 },
    { { { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 } } }));
  // Nodes lie on the ends of an axis, cells within them.
  CHECK(
    IsPlaced(Read(Write(folder, "axis mins: 1 2 3\naxis maxs: 5 8 13\ncenters: node node cell\n")),
      { 1, 2, 4 }, { { { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } } }));
  for (const char* spacings : { "0 1 1", "1 -1 1", "1 1 nan", "1 1 inf", "1 1" })
  {
    INFO(spacings);
    CHECK_THAT(FailureOf(Write(folder, std::string("spacings: ") + spacings + "\n")),
      ContainsSubstring("spacing"));
  }
}

TEST_CASE("Short first axes are voxels, and an axis of one value in a fourth place is none")
{
  const TemporaryFolder folder;
  const std::string fields = "type: short\nendian: little\nencoding: raw\ndimension: 4\n";
  const std::string voxels = "\n" + SampleBytes<short>();
  CHECK(
    IsSample(Read(folder.Write("a.nrrd", "NRRD0004\n" + fields + "sizes: 3 4 5 1\n" + voxels))));
  const auto image = Read(folder.Write("b.nrrd",
    "NRRD0004\n" + fields +
      "sizes: 1 3 4 5\nspace: LPS\nspace directions: none (0,1,0) (1,0,0) (0,0,1)\n"
      "kinds: vector domain domain domain\n" +
      voxels));
  CHECK(IsSample(image));
  CHECK(IsPlaced(image, { 0, 0, 0 }, { { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } } }));
  CHECK_THAT(FailureOf(folder.Write("c.nrrd", "NRRD0004\n" + fields + "sizes: 3 2 2 5\n" + voxels)),
    ContainsSubstring("4 axes"));
}
