#include "SeriesList.h"

#include <vtkCallbackCommand.h>
#include <vtkDICOMVolumeReader.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

namespace penumbra
{
namespace
{
// Ends the listing where nobody wants it any more.
void TellProgress(vtkObject* caller, unsigned long, void* progress, void*)
{
  auto* const reader = static_cast<vtkAlgorithm*>(caller);
  const auto& tell = *static_cast<std::function<bool(double)>*>(progress);
  if (!tell(reader->GetProgress()))
  {
    reader->SetAbortExecute(1);
  }
}
}

//------------------------------------------------------------------------------
std::vector<SeriesFacts> ListSeries(
  const std::filesystem::path& folder, const VoxelReading& reading)
{
  vtkNew<vtkDICOMVolumeReader> reader;
  // What is wrong is told where the volume is read.
  vtkNew<vtkCallbackCommand> silence;
  for (vtkObject* speaker :
    { static_cast<vtkObject*>(reader), static_cast<vtkObject*>(reader->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, silence);
    speaker->AddObserver(vtkCommand::WarningEvent, silence);
  }
  reader->SetFileName(folder.u8string().c_str());
  reader->SetParserProgram(reading.DicomParser.u8string().c_str());
  std::function<bool(double)> progress = reading.Progress;
  vtkNew<vtkCallbackCommand> listener;
  if (progress)
  {
    listener->SetCallback(TellProgress);
    listener->SetClientData(&progress);
    reader->AddObserver(vtkCommand::ProgressEvent, listener);
  }
  reader->UpdateInformation();
  std::vector<SeriesFacts> series;
  for (int i = 0; i < reader->GetNumberOfSeries(); ++i)
  {
    series.push_back({ reader->GetSeriesName(i), reader->GetSeriesModality(i),
      reader->GetSeriesDescription(i), reader->GetSeriesNumberOfImages(i),
      reader->GetSeriesColumns(i), reader->GetSeriesRows(i) });
  }
  return series;
}

}
