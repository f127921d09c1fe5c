#include "FormatReaders.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDICOMVolumeReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace penumbra
{

namespace
{

// Tells the progress and ends the reading where nobody wants it any more.
void TellProgress(vtkObject* caller, unsigned long, void* progress, void*)
{
  auto* const reader = static_cast<vtkAlgorithm*>(caller);
  const auto& tell = *static_cast<std::function<bool(double)>*>(progress);
  if (!tell(reader->GetProgress()))
  {
    reader->SetAbortExecute(1);
  }
}

// The error is thrown, with the file's name, by who asked for the volume.
void Ignore(vtkObject*, unsigned long, void*, void*) {}

void Observe(vtkDICOMVolumeReader* reader, std::function<bool(double)>& progress)
{
  vtkNew<vtkCallbackCommand> errors;
  errors->SetCallback(Ignore);
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  if (progress)
  {
    vtkNew<vtkCallbackCommand> listener;
    listener->SetCallback(TellProgress);
    listener->SetClientData(&progress);
    reader->AddObserver(vtkCommand::ProgressEvent, listener);
  }
}

}

Volume ReadDicomVolume(
  const std::filesystem::path& path, const VolumeReadingOptions& options, Warnings& warnings)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  std::function<bool(double)> progress = options.progress;
  Observe(reader, progress);
  reader->SetFileName(path.u8string().c_str());
  reader->SetSeries(options.series.empty() ? nullptr : options.series.c_str());
  reader->SetParserProgram(options.dicomParser.c_str());
  reader->Update();
  const std::string error = reader->GetErrorMessage();
  if (!error.empty())
  {
    throw VolumeReadingError(error);
  }
  for (vtkIdType index = 0; index < reader->GetWarnings()->GetNumberOfValues(); ++index)
  {
    warnings.push_back(reader->GetWarnings()->GetValue(index));
  }
  return reader->GetOutput();
}

}
