// What a reader tells of what it has read.

#include "vtkDICOMVolumeReaderInternals.h"

using namespace penumbra;

//------------------------------------------------------------------------------
vtkStringArray* vtkDICOMVolumeReader::GetWarnings()
{
  return this->State->Warnings;
}

//------------------------------------------------------------------------------
const char* vtkDICOMVolumeReader::GetErrorMessage()
{
  return this->State->ErrorMessage.c_str();
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::GetNumberOfSeries()
{
  const auto& reading = this->State->Reading;
  return reading ? static_cast<int>(reading->GetSeries().size()) : 0;
}

//------------------------------------------------------------------------------
const char* vtkDICOMVolumeReader::GetSeriesName(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? of->name.c_str() : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkDICOMVolumeReader::GetSeriesModality(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? of->files.front().image.modality.c_str() : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkDICOMVolumeReader::GetSeriesDescription(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? of->files.front().image.seriesDescription.c_str() : nullptr;
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::GetSeriesNumberOfImages(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? static_cast<int>(of->NumberOfImages()) : 0;
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::GetSeriesColumns(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? of->files.front().image.columns : 0;
}

//------------------------------------------------------------------------------
int vtkDICOMVolumeReader::GetSeriesRows(int series)
{
  const DicomSeries* of = this->State->GetSeries(series);
  return of ? of->files.front().image.rows : 0;
}

//------------------------------------------------------------------------------
void vtkDICOMVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto text = [](const char* value) { return value ? value : "(none)"; };
  os << indent << "FileName: " << text(this->FileName) << "\n";
  os << indent << "FileNames: " << this->FileNames << "\n";
  os << indent << "Series: " << text(this->Series) << "\n";
  os << indent << "ParserProgram: " << text(this->ParserProgram) << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "NumberOfSeries: " << this->GetNumberOfSeries() << "\n";
  os << indent << "NumberOfWarnings: " << this->State->Warnings->GetNumberOfValues() << "\n";
  os << indent << "ErrorMessage: " << this->GetErrorMessage() << "\n";
}
