#include "Catch.h"
#include "ReadDicom.h"

#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cmath>

TEST_CASE("Slices are ordered by position, whatever their files and numbers are")
{
  const auto parser = GENERATE(from_range(Parsers()));
  DicomSlices slices;
  for (const int number : { 3, 0, 4, 2, 1 })
  {
    slices.push_back(Slice(number));
    slices.back().elements["InstanceNumber"] = std::to_string(slices.size());
  }
  const auto reading = ReadSlices(slices, parser);
  CHECK(reading.error == "");
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("Slices that descend lie where they say")
{
  auto slices = Slices(5);
  for (int number = 0; number < 5; ++number)
  {
    SetPosition(slices[number], { -10, 20, 30 - 2.5 * number });
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("Slices whose normal leads to the feet lie where they say")
{
  auto slices = Slices(5);
  for (auto& slice : slices)
  {
    SetOrientation(slice, { 1, 0, 0 }, { 0, -1, 0 });
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.Warnings() == "");
  CHECK(Difference(reading.volume, slices) == "");
}

TEST_CASE("One slice is a volume, as thick as it says")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteSlices(folder, { Slice(3) });
  for (const auto& path : { folder.PathOf(""), folder.PathOf("0.dcm") })
  {
    const auto reading = ReadDicom(path, parser);
    CHECK(reading.error == "");
    CHECK(Difference(reading.volume, { Slice(3) }) == "");
    CHECK(reading.volume->GetSpacing()[2] == 2.0);
    CHECK(reading.volume->GetDirectionMatrix()->Determinant() == Approx(1.0));
  }
}

TEST_CASE("One file of a series is told to be one slice")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(4));
  const auto reading = ReadDicom(folder.PathOf("2.dcm"));
  CHECK(Difference(reading.volume, { Slice(2) }) == "");
  CHECK(Mentions(reading.Warnings(), "one slice"));
}

TEST_CASE("Files are read in whatever order they are listed")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(4));
  vtkNew<vtkStringArray> names;
  for (const char* name : { "2.dcm", "0.dcm", "3.dcm", "1.dcm" })
  {
    names->InsertNextValue(folder.PathOf(name));
  }
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("missing").c_str());
  reader->SetFileNames(names);
  reader->SetParserProgram(parser.c_str());
  CHECK(Difference(Update(reader).volume, Slices(4)) == "");

  names->SetNumberOfValues(3);
  names->Modified();
  CHECK(Difference(Update(reader).volume, { Slice(0), Slice(2), Slice(3) }) != "");
}

TEST_CASE("Slices in folders within folders are one series")
{
  const TemporaryFolder folder;
  const auto slices = Slices(4);
  WriteSlices(folder, { slices[0], slices[2] }, "a/b/");
  WriteSlices(folder, { slices[1], slices[3] }, "c/");
  CHECK(Difference(ReadDicom(folder.PathOf("")).volume, slices) == "");
}

TEST_CASE("Positions that are rounded are even")
{
  auto slices = Slices(7);
  for (int number = 0; number < 7; ++number)
  {
    slices[number].elements["ImagePositionPatient"] =
      Text({ -10, 20, std::round(number * 1000.0 / 3) / 1000 });
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.Warnings() == "");
  for (int k = 0; k < 7; ++k)
  {
    INFO("slice " << k);
    CHECK(reading.volume->GetScalarComponentAsDouble(3, 2, k, 0) == 23 + 100 * k * k);
  }
  CHECK(reading.volume->GetSpacing()[2] == Approx(1.0 / 3).epsilon(1e-3));
}

TEST_CASE("The distance between slices is that of their positions, whatever else they say")
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["SliceThickness"] = "9";
    slice.elements["SpacingBetweenSlices"] = "7";
    slice.elements["SliceLocation"] = "0";
  }
  CHECK(Difference(ReadSlices(slices).volume, slices) == "");
}
