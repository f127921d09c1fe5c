#include "Catch.h"
#include "ReadDicom.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkVariant.h"

#include <sstream>

namespace
{

const char* const Secret = "Sheherazade|MRN4711|19010203|Bagdad";

DicomSample Named(DicomSample image)
{
  image.elements["PatientName"] = "Grimm^Sheherazade";
  image.elements["PatientID"] = "MRN4711";
  image.elements["PatientBirthDate"] = "19010203";
  image.elements["PatientAddress"] = "Bagdad";
  return image;
}

std::string FieldText(vtkImageData* volume)
{
  std::string text;
  for (int i = 0; i < volume->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    const auto array = volume->GetFieldData()->GetAbstractArray(i);
    text += array->GetName();
    for (vtkIdType value = 0; value < array->GetNumberOfValues(); ++value)
    {
      text += " " + array->GetVariantValue(value).ToString();
    }
  }
  return text;
}

// All that is said of the images of a folder.
std::string Told(const TemporaryFolder& folder, const std::string& parser)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(folder.PathOf("").c_str());
  reader->SetParserProgram(parser.c_str());
  const auto reading = Update(reader);
  std::string text = reading.error + reading.Warnings() + FieldText(reading.volume);
  for (int series = 0; series < reader->GetNumberOfSeries(); ++series)
  {
    text += std::string(reader->GetSeriesName(series)) + reader->GetSeriesDescription(series) +
      reader->GetSeriesModality(series);
  }
  std::ostringstream print;
  reader->Print(print);
  return text + print.str();
}

}

TEST_CASE("Nothing of the patient is told of a volume")
{
  const auto parser = GENERATE(from_range(Parsers()));
  const TemporaryFolder folder;
  auto slices = Slices(6);
  SetPosition(slices[2], { -10, 20, 36.1 });
  slices[4].columns = 9;
  slices[5].elements["SeriesInstanceUID"] = "";
  for (std::size_t number = 0; number < slices.size(); ++number)
  {
    folder.Write(std::to_string(number), Named(slices[number]).File());
  }
  const auto file = Named(Slice(9)).File();
  folder.Write("cut", file.substr(0, file.size() - 8));
  const auto told = Told(folder, parser);
  CHECK(Mentions(told, "CT"));
  CHECK_FALSE(Mentions(told, Secret));
}

TEST_CASE("Nothing of the patient is told of a file that is refused")
{
  const auto parser = GENERATE(from_range(Parsers()));
  auto image = Slice(0);
  const std::string keyword = GENERATE("Rows", "PixelSpacing", "ImageOrientationPatient");
  image.elements[keyword] = keyword == "Rows" ? "0" : keyword == "PixelSpacing" ? "0\\0" : "1\\2";
  const TemporaryFolder folder;
  folder.Write("image", Named(image).File());
  const auto told = Told(folder, parser);
  CHECK(Mentions(told, "rows|spacing|orientation"));
  CHECK_FALSE(Mentions(told, Secret));
}

TEST_CASE("A volume of a named patient has its other data")
{
  auto slices = Slices(2);
  for (auto& slice : slices)
  {
    slice = Named(slice);
    slice.elements["RescaleIntercept"] = "-1024";
  }
  const auto reading = ReadSlices(slices);
  CHECK(reading.Field("Modality") == "CT");
  CHECK(reading.Field("Units") == "HU");
  CHECK(reading.Field("SeriesInstanceUID") == SampleSeries);
}
