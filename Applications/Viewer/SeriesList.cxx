#include "SeriesList.h"

#include <vtkCallbackCommand.h>
#include <vtkDICOMVolumeReader.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

namespace penumbra
{

//------------------------------------------------------------------------------
std::vector<SeriesFacts> ListSeries(
  const std::filesystem::path& folder, const std::filesystem::path& dicomParser)
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
  reader->SetParserProgram(dicomParser.u8string().c_str());
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
