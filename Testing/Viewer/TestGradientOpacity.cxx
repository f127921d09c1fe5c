#include "AppearancePanel.h"
#include "Catch.h"
#include "GradientOpacityChart.h"
#include "ImageComparison.h"
#include "PresetPanel.h"
#include "TransferFunctionPanel.h"
#include "ViewerSession.h"
#include "VolumeHistogram.h"

#include <QCheckBox>
#include <QTableView>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cmath>

using namespace penumbra;

namespace
{
// What an edit that is seen changes at least; pictures that are the same differ by nothing.
constexpr double Seen = 1.0;

struct GradientSession : ViewerSession
{
  GradientSession() { REQUIRE(this->Open(this->Files.File)); }

  const std::optional<FunctionPoints<1>>& Function()
  {
    return this->Document.GetScene().TransferFunction.GradientOpacity;
  }

  void Switch() { this->Find<QCheckBox>("gradientSwitch")->click(); }
};
}

TEST_CASE("Opacity by gradient is switched on and off, and undone", "[gradient]")
{
  GradientSession session;
  const auto before = session.TakePicture();
  auto* const table = session.Find<QTableView>("Points of gradient opacity");
  CHECK_FALSE(table->isEnabled());
  session.Switch();
  REQUIRE(session.Function());
  CHECK(table->isEnabled());
  CHECK(table->model()->rowCount() == 3);
  CHECK(session.ChangeSince(before) > Seen);
  session.Document.GetHistory()->undo();
  CHECK_FALSE(session.Find<QCheckBox>("gradientSwitch")->isChecked());
  CHECK(session.ChangeSince(before) == 0.0);
  session.Document.GetHistory()->redo();
  session.Switch();
  CHECK_FALSE(session.Function());
  CHECK(session.ChangeSince(before) == 0.0);
}

TEST_CASE("Opacity by gradient is edited in its chart and its table", "[gradient]")
{
  GradientSession session;
  auto* const chart = session.Window.GetAppearance()->GetTransferFunction()->GetGradientChart();
  session.Switch();
  const auto before = session.TakePicture();
  double node[4];
  chart->GetFunction()->GetNodeValue(1, node);
  node[1] = 0.3;
  chart->GetFunction()->SetNodeValue(1, node);
  CHECK((*session.Function())[1][1] == 0.3);
  CHECK(session.ChangeSince(before) > Seen);
  auto* const model = session.Find<QTableView>("Points of gradient opacity")->model();
  CHECK(model->index(1, 1).data() == "0.3");
  model->setData(model->index(1, 1), 0.7);
  CHECK((*session.Function())[1][1] == 0.7);
  chart->GetFunction()->GetNodeValue(1, node);
  CHECK(node[1] == 0.7);
}

TEST_CASE(
  "Opacity by gradient is in the saved scene, and a preset without it ends it", "[gradient]")
{
  GradientSession session;
  session.Switch();
  const auto picture = session.TakePicture();
  const std::string saved = session.Files.PathOf("saved.json");
  session.Window.Save(saved);
  CHECK(CompareImages(picture, RenderScene(saved, session.Files)).rmse < 0.5); // 8-bit rounding
  session.Window.GetAppearance()->GetPresets()->Apply("cloud", {});
  CHECK_FALSE(session.Function());
  REQUIRE(session.Open(saved));
  CHECK(session.Find<QCheckBox>("gradientSwitch")->isChecked());
}

TEST_CASE("The histogram of gradients counts in values per mean voxel", "[gradient]")
{
  // Rises by 3 a voxel along x, which is half as long as the mean voxel: 6 a mean voxel.
  vtkNew<vtkImageData> ramp;
  ramp->SetDimensions(9, 9, 9);
  ramp->SetSpacing(0.005, 0.0125, 0.0125);
  const int type = GENERATE(VTK_SHORT, VTK_FLOAT);
  ramp->AllocateScalars(type, 1);
  for (vtkIdType voxel = 0; voxel < ramp->GetNumberOfPoints(); ++voxel)
  {
    ramp->GetPointData()->GetScalars()->SetTuple1(voxel, 3.0 * (voxel % 9));
  }
  const auto histogram = MakeGradientHistogram(ramp, 24.0);
  double highest = 0.0;
  double value = 0.0;
  for (vtkIdType bin = 0; bin < histogram->GetNumberOfRows(); ++bin)
  {
    if (histogram->GetValue(bin, 1).ToDouble() > highest)
    {
      highest = histogram->GetValue(bin, 1).ToDouble();
      value = histogram->GetValue(bin, 0).ToDouble();
    }
  }
  CHECK(highest == 1.0);
  CHECK(std::abs(value - 6.0) <= 1.0); // a bin of whole numbers, or rounding below 6
  // At the border it is half of that. Gradients beyond the largest are not counted.
  const auto few = MakeGradientHistogram(ramp, 2.0);
  for (vtkIdType bin = 0; bin < few->GetNumberOfRows(); ++bin)
  {
    CHECK(few->GetValue(bin, 1).ToDouble() == 0.0);
  }
}
