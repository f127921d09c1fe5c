#include "Catch.h"
#include "NiftiSample.h"

#include <cmath>

using Catch::Matchers::ContainsSubstring;

TEST_CASE("NIfTI-1 and NIfTI-2 are read in either byte order, compressed or not")
{
  const TemporaryFolder folder;
  for (const int version : { 1, 2 })
  {
    for (const bool bigEndian : { false, true })
    {
      INFO("NIfTI-" << version << (bigEndian ? " big" : " little"));
      NiftiSample sample;
      sample.version = version;
      sample.bigEndian = bigEndian;
      const auto file = sample.File(SampleBytes<short>(bigEndian));
      CHECK(IsSample(Read(folder.Write("a.nii", file))));
      CHECK(IsSample(Read(folder.Write("a.nii.gz", Compressed(file, true)))));
    }
  }
}

TEST_CASE("NIfTI voxels may begin after extensions")
{
  const TemporaryFolder folder;
  NiftiSample sample;
  sample.offset = 368;
  const auto file = sample.File(std::string(16, 'x') + SampleBytes<short>());
  CHECK(IsSample(Read(folder.Write("a.nii", file))));
  CHECK(IsSample(Read(folder.Write("a.nii.gz", Compressed(file, true)))));
  for (const double offset : { 351.0, 352.5, -1.0, std::nan(""), 1e30 })
  {
    sample.offset = offset;
    CHECK_THAT(FailureOf(folder.Write("b.nii", sample.File(SampleBytes<short>()))),
      ContainsSubstring("vox_offset"));
  }
}

TEST_CASE("NIfTI's slope and intercept are applied unless the slope is 0")
{
  const TemporaryFolder folder;
  NiftiSample sample;
  sample.slope = 0.5;
  sample.intercept = -1024.0;
  const auto scaled = Read(folder.Write("a.nii", sample.File(SampleBytes<short>())));
  CHECK(IsSample(scaled, 0.5, -1024.0));
  CHECK(scaled->GetScalarType() == VTK_FLOAT);

  for (const double slope : { 0.0, std::nan("") })
  {
    sample.slope = slope;
    const auto image = Read(folder.Write("b.nii", sample.File(SampleBytes<short>())));
    CHECK(IsSample(image));
    CHECK(image->GetScalarType() == VTK_SHORT);
  }
  sample.slope = 1.0;
  sample.intercept = 0.0;
  CHECK(
    Read(folder.Write("c.nii", sample.File(SampleBytes<short>())))->GetScalarType() == VTK_SHORT);
  sample.datatype = 8;
  sample.bitpix = 32;
  sample.slope = 2.0;
  CHECK(
    Read(folder.Write("d.nii", sample.File(SampleBytes<int>())))->GetScalarType() == VTK_DOUBLE);
}

TEST_CASE("The first of a NIfTI file's steps in time is read, with a warning")
{
  const TemporaryFolder folder;
  NiftiSample sample;
  sample.dim = { 4, 3, 4, 5, 2, 1, 1, 1 };
  const auto file = sample.File(SampleBytes<short>() + std::string(120, 'x'));
  for (const auto& path :
    { folder.Write("a.nii", file), folder.Write("a.nii.gz", Compressed(file, true)) })
  {
    std::vector<std::string> warnings;
    CHECK(IsSample(penumbra::ReadVolumeFile(path, {}, warnings)));
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], ContainsSubstring("2 steps in time"));
  }
  CHECK_THAT(FailureOf(folder.Write("b.nii", sample.File(SampleBytes<short>()))),
    ContainsSubstring("need exactly 592 bytes"));
}

TEST_CASE("NIfTI headers that describe no scalar volume are refused by name")
{
  const TemporaryFolder folder;
  const auto failure = [&](auto change)
  {
    NiftiSample sample;
    change(sample);
    return FailureOf(folder.Write("a.nii", sample.File(SampleBytes<short>())));
  };
  CHECK(failure([](NiftiSample&) {}) == "was read");
  CHECK_THAT(failure([](auto& s) { s.datatype = 128; }), ContainsSubstring("datatype is 128"));
  CHECK_THAT(failure([](auto& s) { s.bitpix = 8; }), ContainsSubstring("bitpix"));
  CHECK_THAT(failure([](auto& s) { s.dim[0] = 0; }), ContainsSubstring("dim[0]"));
  CHECK_THAT(failure([](auto& s) { s.dim[0] = 8; }), ContainsSubstring("dim[0]"));
  CHECK_THAT(failure(
               [](auto& s) {
                 s.dim = { 5, 3, 4, 5, 1, 3, 1, 1 };
               }),
    ContainsSubstring("3 values per voxel"));
  CHECK_THAT(failure([](auto& s) { s.dim[2] = -4; }), ContainsSubstring("dimensions"));
  CHECK_THAT(failure([](auto& s) { s.dim[1] = s.dim[2] = s.dim[3] = 32767; }),
    ContainsSubstring("need exactly"));
  for (const double spacing : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    CHECK_THAT(failure([&](auto& s) { s.pixdim[2] = spacing; }), ContainsSubstring("spacing"));
  }
  const auto separate = NiftiSample().File("").replace(344, 3, "ni1");
  CHECK_THAT(FailureOf(folder.Write("b.nii", separate)), ContainsSubstring(".hdr and .img"));
}
