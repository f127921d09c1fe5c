#include "AppearancePanel.h"
#include "Catch.h"
#include "ImageComparison.h"
#include "PresetPanel.h"
#include "TransferFunctionChart.h"
#include "TransferFunctionPanel.h"
#include "ViewerSession.h"

#include <QListWidget>

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkPiecewiseFunction.h>

using namespace penumbra;

namespace
{
// What an edit that is seen changes at least.
constexpr double Seen = 2.0;

struct AppearanceSession : ViewerSession
{
  AppearanceSession() { REQUIRE(this->Open(this->Files.File)); }

  const TransferFunctionDescription& Function()
  {
    return this->Document.GetScene().TransferFunction;
  }
};
}

TEST_CASE("Points that are moved in the chart change the scene, and undo moves them back")
{
  AppearanceSession session;
  const auto before = session.TakePicture();
  vtkPiecewiseFunction* opacity =
    session.Window.GetAppearance()->GetTransferFunction()->GetChart()->GetOpacity();
  REQUIRE(opacity->GetSize() == 2);
  double node[4];
  opacity->GetNodeValue(1, node);
  node[1] = 0.05;
  opacity->SetNodeValue(1, node);
  CHECK((*session.Function().Opacity)[1][1] == 0.05);
  CHECK(session.ChangeSince(before) > Seen);
  session.Document.GetHistory()->undo();
  CHECK((*session.Function().Opacity)[1][1] == 0.5);
  opacity->GetNodeValue(1, node);
  CHECK(node[1] == 0.5);
  CHECK(session.ChangeSince(before) == 0.0);
}

TEST_CASE("Colours of the chart are those of the picture")
{
  AppearanceSession session;
  const auto before = session.TakePicture();
  vtkColorTransferFunction* color =
    session.Window.GetAppearance()->GetTransferFunction()->GetChart()->GetColor();
  double node[6];
  color->GetNodeValue(1, node);
  node[1] = 0.0;
  color->SetNodeValue(1, node);
  CHECK((*session.Function().Color)[1][1] == 0.0);
  CHECK(session.ChangeSince(before) > Seen);
}

TEST_CASE("Presets change the look, and keep lights and camera")
{
  AppearanceSession session;
  const auto before = session.TakePicture();
  session.Window.GetAppearance()->GetPresets()->Apply("cloud", {});
  CHECK(session.ChangeSince(before) > Seen);
  CHECK(session.Document.GetScene().Lights[0].Name == "key");
  session.Window.GetAppearance()->GetPresets()->Apply("no-such-preset", {});
  CHECK_FALSE(session.Document.GetHistory()->canRedo());
  CHECK(session.Document.GetHistory()->index() == 1);
}

TEST_CASE("The preset in use is marked until the look is edited")
{
  AppearanceSession session;
  auto* const list = session.Find<QListWidget>("presetList");
  const auto marked = [list]
  {
    QStringList names;
    for (int row = 0; row < list->count(); ++row)
    {
      const QString name = list->item(row)->data(Qt::AccessibleTextRole).toString();
      if (name.endsWith(", in use") && list->item(row)->font().bold())
      {
        names << list->item(row)->text();
      }
    }
    return names;
  };
  CHECK(marked().isEmpty());
  session.Window.GetAppearance()->GetPresets()->Apply("cloud", {});
  CHECK(marked() == QStringList("cloud"));
  session.Document.Edit("light", [](SceneDescription& scene) { scene.Lights.clear(); });
  CHECK(marked() == QStringList("cloud"));
  session.Document.Edit(
    "edit", [](SceneDescription& scene) { (*scene.TransferFunction.Opacity)[0][1] = 0.01; });
  CHECK(marked().isEmpty());
  session.Document.GetHistory()->undo();
  CHECK(marked() == QStringList("cloud"));
  REQUIRE(session.Open(session.Files.PathOf("shells.mhd"))); // which chooses one by itself
  CHECK(marked().size() == 1);
}

TEST_CASE("A look that is saved as a preset is the same when it is loaded")
{
  AppearanceSession session;
  session.Document.Edit("edit",
    [](SceneDescription& scene)
    {
      scene.Material.Diffuse = 0.3;
      scene.TransferFunction.GradientOpacity = { { 0.0, 0.0 }, { 10.0, 1.0 } };
    });
  const auto before = session.TakePicture();
  PresetPanel* presets = session.Window.GetAppearance()->GetPresets();
  presets->Save(session.Files.PathOf("look.json"));
  presets->Apply("cloud", {});
  REQUIRE(session.ChangeSince(before) > Seen);
  presets->Apply("look.json", session.Files.PathOf(""));
  CHECK(session.ChangeSince(before) == 0.0);
}

TEST_CASE("Window and level move and stretch all points")
{
  TransferFunctionDescription function;
  function.Opacity = { { 10.0, 0.0 }, { 20.0, 1.0 } };
  function.Color = { { 15.0, 1.0, 1.0, 1.0 } };
  ShiftAndStretch(function, 100.0, 2.0, 15.0);
  CHECK(*function.Opacity == FunctionPoints<1>{ { 105.0, 0.0 }, { 125.0, 1.0 } });
  CHECK((*function.Color)[0][0] == 115.0);
}
