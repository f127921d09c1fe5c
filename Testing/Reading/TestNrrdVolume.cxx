#include "Catch.h"
#include "SampleVolume.h"
#include "vtkDataArray.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

const std::string Start = "NRRD0004\n# a comment: of no meaning\ntype: short\ndimension: 3\n"
                          "sizes: 3 4 5\nkey:=value\nendian: little\n";

}

TEST_CASE("NRRD voxels are read from raw, gzip and text data")
{
  const TemporaryFolder folder;
  const auto voxels = SampleBytes<short>();
  CHECK(IsSample(Read(folder.Write("a.nrrd", Start + "encoding: raw\n\n" + voxels))));
  CHECK(IsSample(
    Read(folder.Write("b.nrrd", Start + "encoding: gzip\n\n" + Compressed(voxels, true)))));
  CHECK(IsSample(Read(folder.Write("c.NRRD", Start + "encoding: text\n\n" + SampleText()))));
  CHECK(IsSample(Read(folder.Write("d.nrrd",
    "NRRD0001\r\ntype: int16\r\ndimension: 3\r\nsizes: 3 4 5\r\nendian: big\r\n"
    "encoding: raw\r\n\r\n" +
      SampleBytes<short>(true)))));
}

TEST_CASE("NRRD text of a byte type is numbers, not letters")
{
  const TemporaryFolder folder;
  const std::string header = "NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 1\nencoding: ascii\n\n";
  const auto image = Read(folder.Write("a.nrrd", header + "65 200"));
  CHECK(image->GetScalarComponentAsDouble(0, 0, 0, 0) == 65);
  CHECK(image->GetScalarComponentAsDouble(1, 0, 0, 0) == 200);
  CHECK_THAT(FailureOf(folder.Write("b.nrrd", header + "65 256")), ContainsSubstring("256"));
  CHECK_THAT(FailureOf(folder.Write("c.nrrd", header + "65 1.5")), ContainsSubstring("1.5"));
  CHECK_THAT(FailureOf(folder.Write("d.nrrd", header + "65 1 2")), ContainsSubstring("more than"));
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
  folder.Write("v.gz", Compressed("skipped" + voxels, true));
  const auto read = [&](const std::string& fields)
  { return Read(folder.Write("a.nhdr", Start + fields)); };
  CHECK(IsSample(read("encoding: raw\nbyte skip: 7\ndata file: v.raw\n")));
  CHECK(IsSample(read("encoding: raw\nbyte skip: -1\ndatafile: v.raw\n\n")));
  CHECK(IsSample(read("encoding: gzip\nbyteskip: 7\ndata file: v.gz\n")));
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
    folder.Write("a.nrrd", header + SampleBytes<long long>()), std::nullopt, warnings);
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
