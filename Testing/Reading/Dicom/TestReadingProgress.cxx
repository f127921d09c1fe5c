#include "Catch.h"
#include "ReadDicom.h"

#include "vtkCommand.h"
#include "vtkNew.h"

#include <algorithm>
#include <iterator>

namespace
{

// Notes the progress and, from `limit` on, ends the reading.
class Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    const auto reader = vtkDICOMVolumeReader::SafeDownCast(caller);
    this->Progress.push_back(reader->GetProgress());
    if (this->Progress.back() >= this->Limit)
    {
      reader->AbortExecuteOn();
    }
  }

  std::vector<double> Progress;
  double Limit = 2.0;
};

void CheckProgress(const DicomSlices& slices)
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  WriteSlices(folder, slices);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  vtkNew<Observer> observer;
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  CHECK(Update(reader).volume->GetDimensions()[2] == 25);
  CHECK(observer->Progress.size() > 5);
  CHECK(std::is_sorted(observer->Progress.begin(), observer->Progress.end()));
  CHECK(observer->Progress.front() >= 0.0);
  CHECK(observer->Progress.back() == 1.0);
}

}

TEST_CASE("Progress rises to 1")
{
  CheckProgress(Slices(25));
}

TEST_CASE("Progress rises to 1 where the last slice needs a larger scalar type")
{
  auto slices = Slices(25);
  for (auto& slice : slices)
  {
    slice.isSigned = true;
    slice.elements["RescaleIntercept"] = "-1024";
    slice.stored = [](int i, int, int) { return i; };
  }
  slices[24].stored = [](int, int, int) { return -32768; };
  CheckProgress(slices);
}

TEST_CASE("Progress is 1 at the end alone where a file is left out")
{
  const auto parser = GENERATE(from_range(Parsers()));
  auto slices = Slices(25);
  for (auto& slice : slices)
  {
    slice.columns = slice.rows = 16;
  }
  slices[12].transferSyntax = gdcm::TransferSyntax::JPEG2000Lossless;
  const TemporaryFolder folder;
  WriteSlices(folder, slices);
  auto file = slices[12].File();
  file.resize(file.size() - 100);
  folder.Write("12.dcm", file);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  vtkNew<Observer> observer;
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  CHECK(Mentions(Update(reader).Warnings(), "12\\.dcm is left out"));
  CHECK(std::count(observer->Progress.begin(), observer->Progress.end(), 1.0) == 1);
}

TEST_CASE("An observer of the progress can end the reading")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const double limit = GENERATE(0.01, 0.3, 0.7);
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(25));
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  vtkNew<Observer> observer;
  observer->Limit = limit;
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  const auto reading = Update(reader);
  CHECK(reading.volume->GetNumberOfPoints() == 0);
  const auto end = std::find_if(observer->Progress.begin(), observer->Progress.end(),
    [&](double progress) { return progress >= limit; });
  // The pipeline may tell its own start and end.
  CHECK(std::distance(end, observer->Progress.end()) <= 3);

  observer->Limit = 2.0;
  reader->Modified();
  CHECK(Difference(Update(reader).volume, Slices(25)) == "");
}

TEST_CASE("What needs more memory than allowed is refused")
{
  const TemporaryFolder folder;
  auto slices = Slices(8);
  for (auto& slice : slices)
  {
    slice.columns = slice.rows = 400;
  }
  WriteSlices(folder, slices);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  const int limit = GENERATE(1000000, 2000000);
  reader->SetMemoryLimit(limit);
  CHECK(Mentions(Update(reader).error, "memory"));
  reader->SetMemoryLimit(0);
  CHECK(Update(reader).volume->GetNumberOfPoints() == 400 * 400 * 8);
}

TEST_CASE("A memory limit too small for the parser program gives an error at most")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(3));
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(PENUMBRA_DICOM_PARSER);
  reader->SetMemoryLimit(1000000);
  const auto reading = Update(reader);
  CHECK(reading.error.empty() == (reading.volume->GetNumberOfPoints() > 0));
  reader->SetMemoryLimit(0);
  CHECK(Difference(Update(reader).volume, Slices(3)) == "");
}

TEST_CASE("A few files with gaps do not make a volume larger than memory")
{
  const auto parser = GENERATE(from_range(Parsers()));
  auto slices = Slices(4);
  SetPosition(slices[3], { -10, 20, 1e9 });
  const auto reading = ReadSlices(slices, parser);
  INFO(reading.error << reading.Warnings());
  CHECK(reading.volume->GetNumberOfPoints() < 1000000);
  CHECK(reading.error.empty() == (reading.volume->GetNumberOfPoints() > 0));
  CHECK(Mentions(reading.error + reading.Warnings(), "[0-9]"));
}

TEST_CASE("What was read stays read until something changes")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(3));
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  Update(reader);
  vtkNew<Observer> observer;
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  CHECK(Difference(Update(reader).volume, Slices(3)) == "");
  CHECK(observer->Progress.empty());
}

TEST_CASE("What is read again is told once")
{
  const auto parser = GENERATE(from_range(Parsers()));
  auto slices = Slices(3);
  for (auto& slice : slices)
  {
    slice.elements["PixelPaddingValue"] = "0";
    slice.stored = [](int i, int j, int) { return i == 0 ? 0 : 1000 + i + j; };
  }
  const TemporaryFolder folder;
  WriteSlices(folder, slices);
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  const auto first = Update(reader);
  CHECK(Mentions(first.Warnings(), "padding"));
  reader->GetOutput()->ReleaseData();
  const auto second = Update(reader);
  CHECK(second.volume->GetNumberOfPoints() == first.volume->GetNumberOfPoints());
  CHECK(second.warnings == first.warnings);
}
