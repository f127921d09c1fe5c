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

TEST_CASE("Listing the series of a folder ends where nobody wants it any more")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(20));
  // The search asks before each of the 20 files, and the parser after it.
  const int last = GENERATE(10, 21);
  int asked = 0;
  VoxelReading reading = { PENUMBRA_DICOM_PARSER, [&](double) { return ++asked < last; } };
  CHECK(ListSeries(folder.PathOf(""), reading).empty());
  CHECK(asked == last);
  reading.Progress = [](double) { return true; };
  CHECK(ListSeries(folder.PathOf(""), reading).size() == 1);
}

TEST_CASE("What lists the series tells how far it is, and is canceled as reading is")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(20));
  WriteSlices(folder, OtherSlices(), "other ");
  SceneOpening opening(PENUMBRA_DICOM_PARSER);
  bool offered = false;
  bool canceled = false;
  double most = 0.0;
  QObject::connect(&opening, &SceneOpening::seriesFound, [&] { offered = true; });
  QObject::connect(&opening, &SceneOpening::canceled, [&] { canceled = true; });
  QObject::connect(&opening, &SceneOpening::progressed, [&](double part) { most = part; });
  OpenRequest request;
  request.File = folder.PathOf("");
  request.AskForSeries = true;
  opening.Start(request);
  REQUIRE(WaitFor([&] { return offered; }));
  CHECK(most > 0.1);

  offered = false;
  opening.Start(request);
  opening.Cancel();
  CHECK(canceled);
  CHECK_FALSE(WaitFor([&] { return offered; }, 0.5));
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
