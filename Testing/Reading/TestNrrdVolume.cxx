#include "Catch.h"
#include "SampleVolume.h"
#include "vtkDataArray.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

const std::string Start = "NRRD0004\n# a comment: of no meaning\ntype: short\ndimension: 3\n"
                          "sizes: 3 4 5\nkey:=value\nendian: little\n";

}

TEST_CASE("NRRD voxels are read from raw and gzip data")
{
  const TemporaryFolder folder;
  const auto voxels = SampleBytes<short>();
  CHECK(IsSample(Read(folder.Write("a.nrrd", Start + "encoding: raw\n\n" + voxels))));
  CHECK(IsSample(
    Read(folder.Write("b.nrrd", Start + "encoding: gzip\n\n" + Compressed(voxels, true)))));
  CHECK(IsSample(Read(folder.Write("c.NRRD",
    "NRRD0001\r\ntype: int16\r\ndimension: 3\r\nsizes: 3 4 5\r\nendian: big\r\n"
    "encoding: raw\r\n\r\n" +
      SampleBytes<short>(true)))));
}

TEST_CASE("NRRD voxels that VTK's reader gets wrong are refused by name")
{
  const TemporaryFolder folder;
  const auto zipped = Compressed("skipped" + SampleBytes<short>(), true);
  CHECK_THAT(FailureOf(folder.Write("a.nrrd", Start + "encoding: text\n\n" + SampleText())),
    ContainsSubstring("\"text\"; raw or gzip is needed"));
  CHECK_THAT(FailureOf(folder.Write("b.nrrd", Start + "encoding: gzip\nbyte skip: 7\n\n" + zipped)),
    ContainsSubstring("byte skip"));
  for (int slice = 0; slice < 5; ++slice)
  {
    folder.Write("v" + std::to_string(slice) + ".gz",
      Compressed(SampleBytes<short>().substr(24 * slice, 24), true));
  }
  CHECK_THAT(FailureOf(folder.Write("c.nhdr", Start + "encoding: gzip\ndata file: v%d.gz 0 4 1\n")),
    ContainsSubstring("in 5 files"));
}

TEST_CASE("Gzip data in several members is one stream")
{
  const TemporaryFolder folder;
  const auto voxels = SampleBytes<short>();
  const auto members = Compressed(voxels.substr(0, 33), true) + Compressed(voxels.substr(33), true);
  CHECK(IsSample(Read(folder.Write("a.nrrd", Start + "encoding: gz\n\n" + members))));
}

TEST_CASE("A NRRD header may name the file of the voxels and skip bytes of it")
{
  const TemporaryFolder folder;
  const auto voxels = SampleBytes<short>();
  folder.Write("v.raw", "skipped" + voxels);
  folder.Write("v.gz", Compressed(voxels, true));
  const auto read = [&](const std::string& fields)
  { return Read(folder.Write("a.nhdr", Start + fields)); };
  CHECK(IsSample(read("encoding: raw\nbyte skip: 7\ndata file: v.raw\n")));
  CHECK(IsSample(read("encoding: raw\nbyte skip: -1\ndatafile: v.raw\n\n")));
  CHECK(IsSample(read("encoding: gzip\ndata file: v.gz\n")));
  CHECK_THAT(FailureOf(folder.Write("b.nhdr", Start + "encoding: raw\ndata file: v.raw\n")),
    ContainsSubstring("need exactly 120 bytes"));
  CHECK_THAT(FailureOf(folder.Write("c.nhdr", Start + "encoding: raw\ndata file: gone\n")),
    ContainsSubstring("gone\" does not exist"));
}

TEST_CASE("Integers of 64 bits become doubles, with a warning")
{
  const TemporaryFolder folder;
  const std::string header =
    "NRRD0004\ntype: int64\ndimension: 3\nsizes: 3 4 5\nendian: little\nencoding: raw\n\n";
  std::vector<std::string> warnings;
  const auto image = penumbra::ReadVolumeFile(
    folder.Write("a.nrrd", header + SampleBytes<long long>()), {}, warnings);
  CHECK(image->GetScalarType() == VTK_DOUBLE);
  CHECK(IsSample(image));
  CHECK(warnings.size() == 1);
}

TEST_CASE("NRRD headers that describe no scalar volume are refused by name")
{
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& fields)
  {
    return FailureOf(folder.Write("a.nrrd", "NRRD0005\n" + fields + "\n\n" + SampleBytes<short>()));
  };
  const std::string raw = "endian: little\nencoding: raw\n";
  const std::string sized = raw + "dimension: 3\nsizes: 3 4 5\n";
  CHECK_THAT(failure(sized), ContainsSubstring("lacks the field \"type\""));
  CHECK_THAT(FailureOf(folder.Write("b.nrrd", "NRRD0005\n" + sized + "type: short\n")),
    ContainsSubstring("header has no end"));
  CHECK_THAT(failure(sized + "type: block"), ContainsSubstring("\"type\" is \"block\""));
  CHECK_THAT(failure(raw + "type: short"), ContainsSubstring("dimension"));
  CHECK_THAT(failure(raw + "type: short\ndimension: 3\nsizes: 3 4"), ContainsSubstring("sizes"));
  CHECK_THAT(
    failure("encoding: raw\ndimension: 3\nsizes: 3 4 5\ntype: short"), ContainsSubstring("endian"));
  CHECK_THAT(failure("encoding: bzip2\ndimension: 3\nsizes: 3 4 5\ntype: short"),
    ContainsSubstring("encoding"));
  CHECK_THAT(failure(raw + "type: short\ndimension: 3\nsizes: 100000 100000 100000"),
    ContainsSubstring("need exactly 2000000000000"));
  CHECK_THAT(
    failure(sized + "type: short\nkinds: RGB-color domain domain"), ContainsSubstring("RGB-color"));
  CHECK_THAT(failure(sized + "type: short\nspace directions: none (1,0) (0,1)"),
    ContainsSubstring("3 values per voxel"));
}
