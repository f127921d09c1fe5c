#include "vtkDICOMVolumeReader.h"

#include "DicomParserProcess.h"
#include "LocalDicomParser.h"
#include "VolumeReadingError.h"
#include "vtkDICOMVolumeReaderInternals.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>

using namespace penumbra;

vtkStandardNewMacro(vtkDICOMVolumeReader);
vtkCxxSetObjectMacro(vtkDICOMVolumeReader, FileNames, vtkStringArray);

namespace
{

// Headers are the smaller part of the work.
constexpr double HeadersPart = 0.2;

vtkTypeUInt64 HalfOfMemory()
{
  vtksys::SystemInformation machine;
  machine.RunMemoryCheck();
  constexpr vtkTypeUInt64 bytesPerMiB = 1048576;
  return static_cast<vtkTypeUInt64>(machine.GetTotalPhysicalMemory()) * bytesPerMiB / 2;
}

std::unique_ptr<DicomParser> MakeParser(const char* program, const DicomParserLimits& limits)
{
  if (!program || !*program)
  {
    return std::make_unique<LocalDicomParser>();
  }
  return std::make_unique<DicomParserProcess>(std::filesystem::u8path(program), limits);
}

std::vector<std::filesystem::path> PathsOf(vtkStringArray* names)
{
  std::vector<std::filesystem::path> paths;
  for (vtkIdType index = 0; index < names->GetNumberOfValues(); ++index)
  {
    paths.push_back(std::filesystem::u8path(std::string(names->GetValue(index))));
  }
  return paths;
}

// Scalars are at least as large as what is stored.
void CheckMemory(const DicomVolumeReading& reading, vtkTypeUInt64 limit)
{
  const auto scalarSize =
    static_cast<vtkTypeUInt64>(reading.GetSelected().files.front().image.pixel.bitsAllocated / 8);
  const vtkTypeUInt64 needed = scalarSize * NumberOfVoxels(reading.GetPlan().geometry, scalarSize);
  if (needed > limit)
  {
    throw VolumeReadingError("its voxels need " + std::to_string(needed) +
      " bytes, more than the memory limit of " + std::to_string(limit));
  }
}

void AddText(vtkFieldData* fields, const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  fields->AddArray(array);
}

}

//------------------------------------------------------------------------------
vtkDICOMVolumeReader::vtkDICOMVolumeReader()
  : State(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkDICOMVolumeReader::~vtkDICOMVolumeReader()
{
  this->SetFileName(nullptr);
  this->SetFileNames(nullptr);
  this->SetSeries(nullptr);
  this->SetParserProgram(nullptr);
}

//------------------------------------------------------------------------------
std::string vtkDICOMVolumeReader::DescribeInput() const
{
  if (this->FileNames && this->FileNames->GetNumberOfValues() > 0)
  {
    return std::to_string(this->FileNames->GetNumberOfValues()) + " files, \"" +
      this->FileNames->GetValue(0) + "\" first";
  }
  return this->FileName ? "\"" + std::string(this->FileName) + "\"" : "without a file name";
}

//------------------------------------------------------------------------------
void vtkDICOMVolumeReader::FindVolume()
{
  Internals& state = *this->State;
  const vtkTypeUInt64 memory = this->MemoryLimit > 0 ? this->MemoryLimit : HalfOfMemory();
  state.Parser = MakeParser(this->ParserProgram, { memory, this->TimeLimit });
  const auto progress = [this](double part)
  {
    this->UpdateProgress(part);
    return !this->GetAbortExecute();
  };
  DicomVolumeReading& reading = state.Reading.emplace();
  if (this->FileNames && this->FileNames->GetNumberOfValues() > 0)
  {
    reading.FindSeries(PathsOf(this->FileNames), *state.Parser, progress);
  }
  else if (this->FileName && *this->FileName)
  {
    reading.FindSeries(std::filesystem::u8path(this->FileName), *state.Parser, progress);
  }
  else
  {
    throw VolumeReadingError("a file, a folder or a list of files is needed");
  }
  reading.SelectSeries(this->Series ? this->Series : "");
  CheckMemory(reading, memory);
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->SetAbortExecute(0);
  this->SetProgressShiftScale(0.0, HeadersPart);
  this->State->Warnings->Initialize();
  VolumeGeometry geometry;
  geometry.dimensions = { 0, 0, 0 };
  if (this->State->Attempt(this, [this]() { this->FindVolume(); }))
  {
    this->TakeWarnings();
    geometry = this->State->Reading->GetPlan().geometry;
  }
  else
  {
    this->State->Reading.reset();
    this->State->Parser.reset();
  }
  this->SetProgressShiftScale(HeadersPart, 1.0 - HeadersPart);
  const int extent[6] = { 0, static_cast<int>(geometry.dimensions[0]) - 1, 0,
    static_cast<int>(geometry.dimensions[1]) - 1, 0, static_cast<int>(geometry.dimensions[2]) - 1 };
  vtkInformation* output = outputs->GetInformationObject(0);
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), geometry.origin.data(), 3);
  output->Set(vtkDataObject::SPACING(), geometry.spacing.data(), 3);
  output->Set(vtkDataObject::DIRECTION(), geometry.direction.data(), 9);
  return 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkDICOMVolumeReader::ReadVoxels()
{
  // Where slices have to be read again, it goes on from where it was.
  double most = 0.0;
  const auto progress = [this, &most](double part)
  {
    most = std::max(most, part);
    this->UpdateProgress(most);
    return !this->GetAbortExecute();
  };
  return this->State->Reading->ReadVoxels(*this->State->Parser, progress);
}

//------------------------------------------------------------------------------
void vtkDICOMVolumeReader::DescribeVolume(vtkImageData* volume)
{
  const DicomSeries& series = this->State->Reading->GetSelected();
  const DicomImage& image = series.files.front().image;
  AddText(volume->GetFieldData(), "Modality", image.modality);
  AddText(volume->GetFieldData(), "Units", image.units);
  AddText(volume->GetFieldData(), "SeriesInstanceUID", image.seriesInstanceUID);
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* volume = vtkImageData::GetData(outputs);
  volume->Initialize();
  vtkSmartPointer<vtkDataArray> voxels;
  // Why there is no volume has been told; the pipeline would add nothing but lines.
  if (!this->State->Reading ||
    !this->State->Attempt(this, [this, &voxels]() { voxels = this->ReadVoxels(); }))
  {
    return 1;
  }
  this->TakeWarnings();
  ApplyGeometry(this->State->Reading->GetPlan().geometry, volume);
  voxels->SetName("DICOM");
  volume->GetPointData()->SetScalars(voxels);
  this->DescribeVolume(volume);
  return 1;
}

//------------------------------------------------------------------------------
void vtkDICOMVolumeReader::TakeWarnings()
{
  this->State->Warnings->Initialize();
  for (const std::string& warning : this->State->Reading->GetWarnings())
  {
    this->State->Warnings->InsertNextValue(warning);
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkDICOMVolumeReader::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->FileNames ? std::max(time, this->FileNames->GetMTime()) : time;
}
