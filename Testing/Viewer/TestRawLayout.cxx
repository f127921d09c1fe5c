#include "Catch.h"
#include "RawImportDialog.h"
#include "TemporaryFolder.h"
#include "ViewerSession.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSpinBox>

using namespace penumbra;

TEST_CASE("What a raw file's name says comes first, if it fills the file")
{
  const auto named = ProposeLayouts("head_20x30x40_int16.raw", 20 * 30 * 40 * 2);
  REQUIRE_FALSE(named.empty());
  CHECK(named[0].Dimensions == std::array<int, 3>{ 20, 30, 40 });
  CHECK(named[0].ScalarType == "int16");
  const auto unnamed = ProposeLayouts("head.raw", 64 * 64 * 64);
  REQUIRE_FALSE(unnamed.empty());
  CHECK(unnamed[0].Dimensions == std::array<int, 3>{ 64, 64, 64 });
  CHECK(unnamed[0].ScalarType == "uint8");
}

TEST_CASE("Every proposal fills the file exactly")
{
  for (const std::uint64_t bytes : { 16777216u, 8388608u, 1000000u, 761856u, 7u, 0u })
  {
    for (const RawLayout& layout : ProposeLayouts("volume.raw", bytes))
    {
      CHECK(layout.Bytes() == bytes);
    }
  }
}

TEST_CASE("A raw file can be opened once its layout fills it, and is read so")
{
  ViewerSession session;
  const std::string file = session.Files.Write("ball.raw", std::string(8 * 9 * 10 * 2, '\1'));
  RawImportDialog dialog(QString::fromStdString(file));
  auto* const open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
  dialog.findChild<QComboBox*>("Type")->setCurrentText("uint16");
  dialog.findChild<QSpinBox*>("Voxels along x")->setValue(8);
  dialog.findChild<QSpinBox*>("Voxels along y")->setValue(9);
  CHECK_FALSE(open->isEnabled());
  dialog.findChild<QSpinBox*>("Voxels along z")->setValue(10);
  CHECK(open->isEnabled());
  OpenRequest request;
  request.File = file;
  request.Settings = dialog.GetLayout().ToSettings();
  const OpenedScene opened = ReadScene(request, {});
  CHECK(opened.Scene.Volume.Dimensions == std::array<int, 3>{ 8, 9, 10 });
  dialog.findChild<QSpinBox*>("Header bytes")->setValue(2);
  CHECK_FALSE(open->isEnabled());
}
