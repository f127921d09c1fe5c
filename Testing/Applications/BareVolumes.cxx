#include "BodyRegion.h"
#include "Catch.h"
#include "PictureLook.h"
#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
const std::string Data = PENUMBRA_DATA;
}

TEST_CASE("What was chosen for a volume is told with its reasons")
{
  const auto choices = LookOf({ Data + "/mr-brain" }).report["choices"];
  REQUIRE(choices.size() == 2);
  CHECK_THAT(
    choices[0].get<std::string>(), ContainsSubstring("mr-head") && ContainsSubstring("MR"));
  CHECK_THAT(choices[1].get<std::string>(), ContainsSubstring("front"));
}

TEST_CASE("The scene saved for a bare volume gives its picture again")
{
  const TemporaryFolder folder;
  const auto render = [&folder](std::vector<std::string> arguments, const std::string& name)
  {
    arguments.insert(arguments.end(), { "--output", folder.PathOf(name) });
    const auto result = RunPenumbraRender(arguments);
    INFO(result.error);
    REQUIRE(result.exitStatus == 0);
    return ReadAll(folder.PathOf(name));
  };
  const auto first = render({ Data + "/brainsmall.mhd", "--set", "image.size=[64,48]",
                              "--save-scene", folder.PathOf("s.json") },
    "first.png");
  CHECK(render({ folder.PathOf("s.json") }, "second.png") == first);
}

TEST_CASE("Settings change a bare volume's lights, of which there are as many as in the preset")
{
  const TemporaryFolder folder;
  const auto result = RunPenumbraRender({ Data + "/brainsmall.mhd", "--set", "lights.2.on=false",
    "--set", "transferFunction.preset=mr-brain", "--set", "image.size=[16,16]", "--save-scene",
    folder.PathOf("s.json"), "--output", folder.PathOf("p.png") });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const auto saved = nlohmann::json::parse(ReadAll(folder.PathOf("s.json")));
  CHECK(saved["lights"].size() == 3);
  CHECK(saved["lights"][0]["shadow"] == "soft");
  CHECK(saved["lights"][2]["on"] == false);
  CHECK(saved["material"]["specular"] == 0.0); // clay's
}

TEST_CASE("A .raw volume stands on its long axis")
{
  const TemporaryFolder folder;
  std::string voxels(8 * 40 * 8, '\0');
  for (int voxel = 0; voxel < 8 * 40 * 8; ++voxel)
  {
    const int x = voxel % 8;
    const int z = voxel / 320;
    voxels[voxel] = x > 1 && x < 6 && z > 1 && z < 6 ? '\xc8' : '\0';
  }
  const auto look = LookOf({ folder.Write("v.raw", voxels), "--set", "volume.dimensions=[8,40,8]",
    "--set", "volume.scalarType=uint8", "--save-scene", folder.PathOf("s.json") });
  CHECK_THAT(look.report["choices"].back().get<std::string>(), ContainsSubstring("longest axis"));
  const auto saved = nlohmann::json::parse(ReadAll(folder.PathOf("s.json")));
  CHECK(saved["camera"]["viewUp"] == nlohmann::json({ 0.0, 1.0, 0.0 }));
  // It fills the picture's height.
  CHECK(look.foreground > 0.08);
}

TEST_CASE("The scanner's table is not the body")
{
  // A body of 240 x 160 mm, 60 slices; 24 mm below it a table of 8 mm.
  vtkNew<vtkImageData> image;
  image->SetDimensions(100, 100, 20);
  image->SetSpacing(4.0, 4.0, 4.0);
  image->SetOrigin(-200.0, -180.0, 0.0);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* voxels = static_cast<short*>(image->GetScalarPointer());
  for (int voxel = 0; voxel < 100 * 100 * 20; ++voxel)
  {
    const double x = (voxel % 100 - 50) / 30.0;
    const double y = (voxel / 100 % 100 - 40) / 20.0;
    const int row = voxel / 100 % 100;
    const bool isTable = row == 66 || row == 67;
    voxels[voxel] = x * x + y * y < 1.0 ? 40 : isTable ? 100 : -1000;
  }
  const auto region = FindBodyRegion(image, 0.0);
  REQUIRE(region);
  CHECK((*region)[0] == Approx(-200.0 + 4.0 * 20).margin(8.0));
  CHECK((*region)[1] == Approx(-200.0 + 4.0 * 80).margin(8.0));
  CHECK((*region)[3] == Approx(-180.0 + 4.0 * 60).margin(8.0)); // above the table
  CHECK((*region)[4] == 0.0);
  CHECK((*region)[5] == 76.0);
  CHECK((*FindBodyRegion(image, -8.0))[3] == Approx((*region)[3] - 8.0));
}

TEST_CASE("A body that fills the volume is not cropped")
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 20);
  image->SetSpacing(4.0, 4.0, 4.0);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), 8000, short(40));
  CHECK_FALSE(FindBodyRegion(image, 6.0));
}
