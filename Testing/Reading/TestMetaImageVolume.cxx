#include "Catch.h"
#include "SampleVolume.h"
#include "vtkMetaImageWriter.h"
#include "vtkNew.h"

using Catch::Matchers::ContainsSubstring;

namespace
{

const std::string Start = "ObjectType = Image\nNDims = 3\nDimSize = 3 4 5\n";
const std::string End = "ElementType = MET_SHORT\nElementDataFile = LOCAL\n";

}

TEST_CASE("MetaImage voxels are read from raw and compressed data")
{
  const TemporaryFolder folder;
  const auto voxels = SampleBytes<short>();
  CHECK(IsSample(Read(folder.Write("a.mha", Start + End + voxels))));
  CHECK(IsSample(Read(folder.Write(
    "b.mha", Start + "BinaryDataByteOrderMSB = True\n" + End + SampleBytes<short>(true)))));
  const auto compressed = Compressed(voxels, false);
  const std::string size = std::to_string(compressed.size());
  CHECK(IsSample(Read(folder.Write("c.MHA",
    Start + "CompressedData = True\nCompressedDataSize = " + size + "\n" + End + compressed))));
  folder.Write("my data.zraw", compressed);
  CHECK(IsSample(Read(folder.Write("d.mhd",
    Start + "CompressedData = True\nElementType = MET_SHORT\nElementDataFile = my data.zraw\n"))));

  folder.Write("my data.raw", "skipped" + voxels);
  const std::string detached = "ElementType = MET_SHORT\nElementDataFile = my data.raw\n";
  CHECK(IsSample(Read(folder.Write("e.mhd", Start + "HeaderSize = 7\n" + detached))));
  CHECK(IsSample(Read(folder.Write("f.mhd", Start + "HeaderSize = -1\r\n" + detached))));
  CHECK_THAT(FailureOf(folder.Write("g.mhd", Start + detached)),
    ContainsSubstring("holds 127 bytes") && ContainsSubstring("need exactly 120 bytes"));
}

TEST_CASE("MetaImages that VTK's reader cannot be trusted with are refused by name")
{
  const TemporaryFolder folder;
  CHECK_THAT(
    FailureOf(folder.Write("a.mha", Start + "BinaryData = False\n" + End + SampleBytes<short>())),
    ContainsSubstring("BinaryData"));
  const auto voxels = Compressed(SampleBytes<short>(), false);
  const std::string size = "CompressedDataSize = " + std::to_string(voxels.size()) + "\n";
  const auto failure = [&](const std::string& fields)
  {
    return FailureOf(
      folder.Write("b.mha", Start + "CompressedData = True\n" + fields + End + voxels));
  };
  CHECK(failure(size) == "was read");
  CHECK_THAT(failure(""), ContainsSubstring("lacks CompressedDataSize"));
  CHECK_THAT(failure("CompressedDataSize = 7\n"), ContainsSubstring("CompressedDataSize is 7"));
  CHECK_THAT(
    failure(size + "Comment = " + std::string(300, 'x') + "\n"), ContainsSubstring("250 bytes"));
  CHECK_THAT(failure(size + "ID = x\n"), ContainsSubstring("ID is"));
  CHECK_THAT(failure(size + "no key\n"), ContainsSubstring("\"no key\""));
  CHECK_THAT(failure(size + "HeaderSize = 3\n"), ContainsSubstring("HeaderSize is 3"));
  const auto longs = Compressed(SampleBytes<int>(), false);
  CHECK_THAT(
    FailureOf(folder.Write("c.mha",
      Start + "CompressedData = True\nCompressedDataSize = " + std::to_string(longs.size()) +
        "\nElementType = MET_LONG\nElementDataFile = LOCAL\n" + longs)),
    ContainsSubstring("MET_LONG"));
  CHECK(IsSample(Read(folder.Write("d.mha",
    Start + "Comment = " + std::string(300, 'x') +
      "\nElementType = MET_LONG\nElementDataFile = LOCAL\n" + SampleBytes<int>()))));
}

TEST_CASE("Each row of a MetaImage's TransformMatrix is the direction of an index axis")
{
  const TemporaryFolder folder;
  const std::string placed = Start + "TransformMatrix = 0 1 0 0 0 1 1 0 0\n" +
    "Offset = 10 20 30\nElementSpacing = 2 3 4\nCenterOfRotation = 0 0 0\n" + End +
    SampleBytes<short>();
  CHECK(IsPlaced(Read(folder.Write("a.mha", placed)), { 10, 20, 30 },
    { { { 0, 2, 0 }, { 0, 0, 3 }, { 4, 0, 0 } } }));
}

TEST_CASE("A MetaImage's mirroring, oblique directions stay, sheared ones are refused")
{
  const TemporaryFolder folder;
  const auto withMatrix = [&](const std::string& matrix)
  {
    return folder.Write(
      "a.mha", Start + "TransformMatrix = " + matrix + "\n" + End + SampleBytes<short>());
  };
  CHECK(IsPlaced(Read(withMatrix("0.6 0.8 0 -0.8 0.6 0 0 0 -1")), { 0, 0, 0 },
    { { { 0.6, 0.8, 0 }, { -0.8, 0.6, 0 }, { 0, 0, -1 } } }));
  // Four digits of a turn by 30 degrees: not exactly perpendicular, but meant to be.
  CHECK(IsPlaced(Read(withMatrix("0.8660 0.5001 0 -0.5 0.866 0 0 0 1")), { 0, 0, 0 },
    { { { 0.8660, 0.5, 0 }, { -0.5, 0.8660, 0 }, { 0, 0, 1 } } }, 1e-3));
  CHECK_THAT(FailureOf(withMatrix("1 0 0 0.01 1 0 0 0 1")), ContainsSubstring("sheared"));
  CHECK_THAT(FailureOf(withMatrix("1 0 0 1 0 0 0 0 1")), ContainsSubstring("sheared"));
  CHECK_THAT(FailureOf(withMatrix("1 0 0 0 0 0 0 0 1")), ContainsSubstring("axis 2"));
  CHECK_THAT(FailureOf(withMatrix("1 0 0 0 nan 0 0 0 1")), ContainsSubstring("axis 2"));
  CHECK_THAT(FailureOf(withMatrix("1 0 0 0 1 0")), ContainsSubstring("TransformMatrix"));
}

TEST_CASE("What VTK writes as MetaImage is read")
{
  const TemporaryFolder folder;
  const auto sample = Read(folder.Write(
    "a.mha", Start + "Offset = 1 2 3\nElementSpacing = 2 3 4\n" + End + SampleBytes<short>()));
  for (const bool compressed : { false, true })
  {
    vtkNew<vtkMetaImageWriter> writer;
    writer->SetInputData(sample);
    writer->SetFileName(folder.PathOf("b.mha").c_str());
    writer->SetCompression(compressed);
    writer->Write();
    const auto image = Read(folder.PathOf("b.mha"));
    CHECK(IsSample(image));
    CHECK(IsPlaced(image, { 1, 2, 3 }, { { { 2, 0, 0 }, { 0, 3, 0 }, { 0, 0, 4 } } }));
  }
}

TEST_CASE("MetaImage headers that describe no scalar volume are refused by name")
{
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& lines)
  { return FailureOf(folder.Write("a.mha", lines + SampleBytes<short>())); };
  CHECK_THAT(failure("NDims = 4\nDimSize = 3 4 5 1\n" + End), ContainsSubstring("NDims"));
  CHECK_THAT(failure("NDims = 3\n" + End), ContainsSubstring("lacks DimSize"));
  CHECK_THAT(failure("NDims = 3\nDimSize = 3 4\n" + End), ContainsSubstring("DimSize"));
  CHECK_THAT(failure("NDims = 3\nDimSize = 3 4 x\n" + End), ContainsSubstring("DimSize"));
  CHECK_THAT(failure("NDims = 3\nDimSize = 3 -4 5\n" + End), ContainsSubstring("dimensions"));
  CHECK_THAT(failure("NDims = 3\nDimSize = 100000 100000 100000\n" + End),
    ContainsSubstring("need exactly 2000000000000"));
  for (const char* spacing : { "0 1 1", "1 -1 1", "1 1 nan", "1 inf 1", "1 1" })
  {
    CHECK_THAT(failure(Start + "ElementSpacing = " + spacing + "\n" + End),
      ContainsSubstring("spacing") || ContainsSubstring("ElementSpacing"));
  }
  CHECK_THAT(
    failure(Start + "ElementNumberOfChannels = 3\n" + End), ContainsSubstring("per voxel"));
  CHECK_THAT(failure(Start + "ElementType = MET_STRING\nElementDataFile = LOCAL\n"),
    ContainsSubstring("ElementType"));
  CHECK_THAT(failure(Start + "ElementDataFile = LOCAL\n"), ContainsSubstring("lacks ElementType"));
  CHECK_THAT(failure(Start + "ElementType = MET_SHORT\nElementDataFile = gone.raw\n"),
    ContainsSubstring("gone.raw") && ContainsSubstring("does not exist"));
}
