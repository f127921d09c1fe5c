#include "Catch.h"
#include "ReadDicom.h"

#include "vtkNew.h"

namespace
{

const char* const OtherSeries = "1.2.3.4.200";

// Fewer slices than the sample series, but more voxels.
DicomSlices LargeSlices()
{
  auto slices = Slices(2);
  for (auto& slice : slices)
  {
    slice.columns = 11;
    slice.rows = 9;
    slice.elements["SeriesInstanceUID"] = OtherSeries;
    slice.elements["SeriesNumber"] = "8";
    slice.elements["SeriesDescription"] = "Thin and large";
    slice.elements["Modality"] = "MR";
  }
  return slices;
}

void WriteBoth(const TemporaryFolder& folder)
{
  WriteSlices(folder, Slices(5));
  WriteSlices(folder, LargeSlices(), "large ");
}

}

TEST_CASE("Of two series the one with more voxels is read and the other is named")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteBoth(folder);
  const auto reading = ReadDicom(folder.PathOf(""), parser);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, LargeSlices()) == "");
  CHECK(reading.Field("SeriesInstanceUID") == OtherSeries);
  CHECK(reading.Field("Modality") == "MR");
  CHECK(Mentions(reading.Warnings(), "1\\.2\\.3\\.4\\.100\\b"));
}

TEST_CASE("The series that is named is read")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteBoth(folder);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  reader->SetSeries(SampleSeries);
  const auto reading = Update(reader);
  CHECK(reading.error == "");
  CHECK(Difference(reading.volume, Slices(5)) == "");
  CHECK(reading.Field("SeriesInstanceUID") == SampleSeries);
  reader->SetSeries(OtherSeries);
  CHECK(Difference(Update(reader).volume, LargeSlices()) == "");
  reader->SetSeries(nullptr);
  CHECK(Difference(Update(reader).volume, LargeSlices()) == "");
}

TEST_CASE("The series are listed without reading their voxels, the largest first")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteBoth(folder);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  reader->UpdateInformation();
  REQUIRE(reader->GetNumberOfSeries() == 2);
  CHECK(reader->GetSeriesName(0) == std::string(OtherSeries));
  CHECK(reader->GetSeriesName(1) == std::string(SampleSeries));
  CHECK(reader->GetSeriesModality(0) == std::string("MR"));
  CHECK(reader->GetSeriesModality(1) == std::string("CT"));
  CHECK(reader->GetSeriesDescription(0) == std::string("Thin and large"));
  CHECK(reader->GetSeriesDescription(1) == std::string(""));
  CHECK(reader->GetSeriesNumberOfImages(0) == 2);
  CHECK(reader->GetSeriesNumberOfImages(1) == 5);
  CHECK(reader->GetSeriesColumns(0) == 11);
  CHECK(reader->GetSeriesRows(0) == 9);
  CHECK(reader->GetSeriesColumns(1) == 4);
  CHECK(reader->GetSeriesRows(1) == 3);
}

TEST_CASE("A series that is not there is refused and those that are there are named")
{
  const TemporaryFolder folder;
  WriteBoth(folder);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetSeries("1.2.3.4.300");
  const auto error = Update(reader).error;
  CHECK(Mentions(error, "1\\.2\\.3\\.4\\.300\\b"));
  CHECK(Mentions(error, "1\\.2\\.3\\.4\\.200\\b"));
  CHECK(Mentions(error, "1\\.2\\.3\\.4\\.100\\b"));
}

TEST_CASE("Series without a UID are told apart by their numbers and have names")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  auto slices = Slices(5);
  auto large = LargeSlices();
  for (auto* const some : { &slices, &large })
  {
    for (auto& slice : *some)
    {
      slice.elements.erase("SeriesInstanceUID");
      slice.elements.erase("SeriesDescription");
      slice.elements["Modality"] = "CT";
    }
  }
  WriteSlices(folder, slices);
  WriteSlices(folder, large, "large ");
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  CHECK(Difference(Update(reader).volume, large) == "");
  REQUIRE(reader->GetNumberOfSeries() == 2);
  const std::string names[2] = { reader->GetSeriesName(0), reader->GetSeriesName(1) };
  CHECK(names[0] != names[1]);
  for (const auto& name : names)
  {
    CHECK((name == "without-uid-1" || name == "without-uid-2"));
  }
  reader->SetSeries(names[1].c_str());
  CHECK(Difference(Update(reader).volume, slices) == "");
}

TEST_CASE("An empty series UID is none")
{
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["SeriesInstanceUID"] = "";
  }
  CHECK(Difference(ReadSlices(slices).volume, slices) == "");
}

TEST_CASE("A long description is shortened between two characters")
{
  auto slices = Slices(2);
  std::string description = "x";
  for (int letter = 0; letter < 600; ++letter)
  {
    description += "\u00e4";
  }
  slices[0].elements["SeriesDescription"] = description;
  slices[1].elements["SeriesDescription"] = description;
  const TemporaryFolder folder;
  WriteSlices(folder, slices);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  Update(reader);
  const std::string described = reader->GetSeriesDescription(0);
  CHECK(described == description.substr(0, 999) + "...");
}
