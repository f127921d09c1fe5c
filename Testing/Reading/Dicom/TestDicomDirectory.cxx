#include "Catch.h"
#include "ReadDicom.h"

#include "gdcmDICOMDIRGenerator.h"
#include "gdcmWriter.h"

#include <filesystem>

namespace
{

// What a record of the directory must have.
DicomSlices ListedSlices(int count)
{
  auto slices = Slices(count);
  for (auto& slice : slices)
  {
    for (const auto& [keyword, value] : DicomElements{ { "PatientID", "1" },
           { "PatientName", "Nobody" }, { "StudyDate", "20200102" }, { "StudyTime", "101112" },
           { "StudyID", "1" }, { "StudyDescription", "" }, { "AccessionNumber", "1" } })
    {
      slice.elements[keyword] = value;
    }
  }
  return slices;
}

void WriteDirectory(const TemporaryFolder& folder, int count)
{
  std::vector<std::string> names;
  for (int number = 0; number < count; ++number)
  {
    names.push_back(folder.PathOf("IMAGES/" + std::to_string(number)));
  }
  gdcm::DICOMDIRGenerator generator;
  generator.SetFilenames(names);
  const auto root = std::filesystem::u8path(folder.PathOf("IMAGES")).parent_path();
  generator.SetRootDirectory(root.u8string());
  generator.SetDescriptor("SAMPLE");
  REQUIRE(generator.Generate());
  gdcm::Writer writer;
  writer.SetFile(generator.GetFile());
  const auto path = folder.PathOf("DICOMDIR");
  writer.SetFileName(path.c_str());
  REQUIRE(writer.Write());
}

DicomSlices WriteDisc(const TemporaryFolder& folder)
{
  const auto slices = ListedSlices(5);
  for (int number = 0; number < 5; ++number)
  {
    folder.Write("IMAGES/" + std::to_string(number), slices[number].File());
  }
  WriteDirectory(folder, 5);
  return slices;
}

}

TEST_CASE("The images that a DICOMDIR lists are read")
{
  const TemporaryFolder folder;
  const auto slices = WriteDisc(folder);
  auto unlisted = Slice(9);
  unlisted.columns = 40;
  unlisted.elements["SeriesInstanceUID"] = "1.2.3.4.300";
  folder.Write("IMAGES/OTHER", unlisted.File());
  for (const auto& parser : Parsers())
  {
    const auto reading = ReadDicom(folder.PathOf("DICOMDIR"), parser);
    CHECK(reading.error == "");
    CHECK(reading.Warnings() == "");
    CHECK(Difference(reading.volume, slices) == "");
  }
}

TEST_CASE("A DICOMDIR in a folder does not matter")
{
  const TemporaryFolder folder;
  const auto slices = WriteDisc(folder);
  for (const auto& parser : Parsers())
  {
    const auto reading = ReadDicom(folder.PathOf(""), parser);
    CHECK(reading.error == "");
    CHECK(reading.Warnings() == "");
    CHECK(Difference(reading.volume, slices) == "");
  }
}

TEST_CASE("A file that a DICOMDIR lists and that is missing is told")
{
  const TemporaryFolder folder;
  auto slices = WriteDisc(folder);
  std::filesystem::remove(folder.PathOf("IMAGES/4"));
  slices.pop_back();
  for (const auto& parser : Parsers())
  {
    const auto reading = ReadDicom(folder.PathOf("DICOMDIR"), parser);
    CHECK(reading.error == "");
    CHECK(Mentions(reading.Warnings(), "IMAGES.4|\\b1\\b"));
    CHECK(Difference(reading.volume, slices) == "");
  }
}

TEST_CASE("A DICOMDIR of missing files is refused")
{
  const TemporaryFolder folder;
  WriteDisc(folder);
  std::filesystem::remove_all(folder.PathOf("IMAGES"));
  for (const auto& parser : Parsers())
  {
    CHECK(Mentions(ReadDicom(folder.PathOf("DICOMDIR"), parser).error, "DICOMDIR"));
  }
}
