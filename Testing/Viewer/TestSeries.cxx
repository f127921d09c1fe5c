#include "Catch.h"
#include "DicomSlices.h"
#include "SeriesDialog.h"
#include "ViewerSession.h"

#include <QTableWidget>

#include <vtkImageData.h>

using namespace penumbra;

namespace
{
DicomSlices OtherSlices()
{
  DicomSlices slices = Slices(2);
  for (DicomSample& slice : slices)
  {
    slice.elements["SeriesInstanceUID"] = "1.2.3.4.200";
    slice.elements["SeriesDescription"] = "Two slices";
  }
  return slices;
}
}

TEST_CASE("The series of a folder are offered, and the one that is chosen is read")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(5));
  WriteSlices(folder, OtherSlices(), "other ");
  SceneOpening opening(PENUMBRA_DICOM_PARSER);
  SeriesChoice offered;
  OpenRequest request;
  QObject::connect(&opening, &SceneOpening::seriesFound,
    [&](const OpenRequest& asked, const SeriesChoice& series)
    {
      request = asked;
      offered = series;
    });
  OpenRequest first;
  first.File = folder.PathOf("");
  first.AskForSeries = true;
  opening.Start(first);
  REQUIRE(WaitFor([&] { return !offered.empty(); }));
  REQUIRE(offered.size() == 2);
  CHECK(offered[0].Slices == 5);
  CHECK(offered[1].Description == "Two slices");

  SeriesDialog dialog(offered);
  auto* const table = dialog.findChild<QTableWidget*>("seriesTable");
  CHECK(table->item(1, 1)->text() == "Two slices");
  table->selectRow(1);
  request.Settings = { "volume.series=\"" + dialog.GetChosen().Uid + "\"" };
  const OpenedScene opened = ReadScene(request, { PENUMBRA_DICOM_PARSER, {} });
  CHECK(opened.Voxels.Volume->GetDimensions()[2] == 2);
}
