#include "Catch.h"
#include "SampleVolume.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

const std::string MetaImage =
  "NDims = 3\nDimSize = 3 4 5\nElementType = MET_SHORT\nElementDataFile = ";
const std::string Nrrd =
  "NRRD0004\ntype: short\ndimension: 3\nsizes: 3 4 5\nendian: little\nencoding: raw\ndata file: ";
const std::string Names = "\nv08.raw\nv10.raw\nv12.raw\nv14.raw\nv16.raw\n";

// v08.raw, v10.raw to v16.raw, one slice in each.
void WriteSlices(const TemporaryFolder& folder)
{
  const auto voxels = SampleBytes<short>();
  for (int slice = 0; slice < 5; ++slice)
  {
    const std::string number = std::to_string(8 + 2 * slice);
    folder.Write(
      "v" + std::string(2 - number.size(), '0') + number + ".raw", voxels.substr(24 * slice, 24));
  }
}

}

TEST_CASE("Voxels may be spread over files given as a list or as a pattern")
{
  const TemporaryFolder folder;
  WriteSlices(folder);
  CHECK(IsSample(Read(folder.Write("a.mhd", MetaImage + "LIST" + Names))));
  CHECK(IsSample(Read(folder.Write("b.mhd", MetaImage + "v%02d.raw 8 16 2\n"))));
  CHECK(IsSample(Read(folder.Write("a.nhdr", Nrrd + "LIST" + Names))));
  CHECK(IsSample(Read(folder.Write("b.nhdr", Nrrd + "v%02d.raw 8 16 2\n"))));
}

TEST_CASE("Files that are missing, too many or of another size are refused")
{
  const TemporaryFolder folder;
  WriteSlices(folder);
  const auto failure = [&](const std::string& files)
  { return FailureOf(folder.Write("a.mhd", MetaImage + files)); };
  CHECK_THAT(failure("v%02d.raw 8 18 2\n"), ContainsSubstring("v18.raw"));
  CHECK_THAT(failure("LIST\nv08.raw\nv10.raw\n"), ContainsSubstring("2 files"));
  CHECK_THAT(failure("LIST\n"), ContainsSubstring("0 files"));
  CHECK_THAT(failure("LIST" + Names + "v08.raw\n"), ContainsSubstring("6 files"));
  folder.Write("v12.raw", "short");
  CHECK_THAT(failure("LIST" + Names), ContainsSubstring("\"v12.raw\" holds 5 bytes"));
}

TEST_CASE("Patterns and numbers that lead nowhere are refused")
{
  const TemporaryFolder folder;
  for (const char* files : { "v%s.raw 1 5 1", "v%d%d.raw 1 5 1", "v%n 1 5 1", "v% 1 5 1",
         "v%099d.raw 1 5 1", "v%d.raw 1 5 0", "v%d.raw 5 1 1", "v%d.raw -1 5 1", "v%d.raw 1 5 -1",
         "v%d.raw 0 9000000000000000000 1", "v%d.raw 1 x 1" })
  {
    INFO(files);
    const auto failure = FailureOf(folder.Write("a.mhd", MetaImage + files + "\n"));
    CHECK_THAT(failure, ContainsSubstring("data files") || ContainsSubstring("ElementDataFile"));
    CHECK_FALSE(FailureOf(folder.Write("a.nhdr", Nrrd + files + "\n")) == "was read");
  }
}
