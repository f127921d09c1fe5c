#include "ReadDicom.h"

#include "Catch.h"
#include "vtkAbstractArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <regex>

namespace
{

// Takes what else would be shown on the terminal.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Texts.push_back(static_cast<const char*>(text));
  }

  std::vector<std::string> Texts;
};

bool IsLine(const std::string& text)
{
  return !text.empty() && text.find_first_of("\r\n") == std::string::npos;
}

// What vtkErrorMacro was given: its text begins with a line and an address of its own, and ends
// with two line feeds.
std::string ErrorOf(const std::string& text)
{
  const auto start = text.find("): ", text.find('\n'));
  REQUIRE(start != std::string::npos);
  return text.substr(start + 3, text.find_last_not_of('\n') - start - 2);
}

std::string CheckError(vtkDICOMVolumeReader* reader, const Messages& errors)
{
  const std::string message = reader->GetErrorMessage();
  if (message.empty() || Mentions(message, "cancel"))
  {
    CHECK(errors.Texts.empty());
    return message;
  }
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  REQUIRE(errors.Texts.size() == 1);
  const auto error = ErrorOf(errors.Texts[0]);
  CHECK(IsLine(error));
  CHECK_THAT(error, Catch::Matchers::ContainsSubstring(message));
  return error;
}

void CheckVolume(vtkImageData* volume)
{
  if (volume->GetNumberOfPoints() == 0)
  {
    return;
  }
  REQUIRE(volume->GetPointData()->GetScalars());
  CHECK(volume->GetPointData()->GetScalars()->GetNumberOfTuples() == volume->GetNumberOfPoints());
  CHECK(volume->GetNumberOfScalarComponents() == 1);
  const int* const extent = volume->GetExtent();
  CHECK(std::vector<int>{ extent[0], extent[2], extent[4] } == std::vector<int>{ 0, 0, 0 });
}

}

std::string DicomReading::Warnings() const
{
  std::string lines;
  for (const auto& warning : this->warnings)
  {
    lines += warning + "\n";
  }
  return lines;
}

std::string DicomReading::Field(const char* name) const
{
  const auto array =
    vtkStringArray::SafeDownCast(this->volume->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? array->GetValue(0) : "";
}

std::vector<std::string> Parsers()
{
  return { "", PENUMBRA_DICOM_PARSER };
}

DicomReading Update(vtkDICOMVolumeReader* reader)
{
  vtkNew<Messages> errors;
  vtkNew<Messages> others;
  const auto readers = reader->AddObserver(vtkCommand::ErrorEvent, errors);
  const auto pipelines = reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, others);
  reader->Update();
  reader->RemoveObserver(readers);
  reader->GetExecutive()->RemoveObserver(pipelines);

  DicomReading reading;
  reading.volume = vtkSmartPointer<vtkImageData>::New();
  reading.volume->ShallowCopy(reader->GetOutput());
  reading.error = CheckError(reader, *errors);
  for (vtkIdType i = 0; i < reader->GetWarnings()->GetNumberOfValues(); ++i)
  {
    reading.warnings.push_back(reader->GetWarnings()->GetValue(i));
    CHECK(IsLine(reading.warnings.back()));
  }
  CheckVolume(reading.volume);
  return reading;
}

bool Mentions(const std::string& text, const std::string& expression)
{
  return std::regex_search(text, std::regex(expression, std::regex::icase));
}

DicomReading ReadDicom(const std::string& path, const std::string& parserProgram)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetParserProgram(parserProgram.empty() ? nullptr : parserProgram.c_str());
  return Update(reader);
}

DicomReading ReadSlices(const DicomSlices& slices, const std::string& parserProgram)
{
  const TemporaryFolder folder;
  WriteSlices(folder, slices);
  return ReadDicom(folder.PathOf(""), parserProgram);
}
