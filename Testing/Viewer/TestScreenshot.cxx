#include "Catch.h"
#include "ImageComparison.h"
#include "RunProgram.h"
#include "ViewerSession.h"

#include <vtkImageData.h>

#include <algorithm>
#include <filesystem>

using namespace penumbra;

namespace
{
int LargestLevel(vtkImageData* picture)
{
  const auto* levels = static_cast<unsigned char*>(picture->GetScalarPointer());
  const auto count = picture->GetNumberOfPoints() * picture->GetNumberOfScalarComponents();
  return *std::max_element(levels, levels + count);
}
}

TEST_CASE("The screenshot shows the whole window with the scene in it")
{
  const ShellsScene files;
  const std::string picture = files.PathOf("window.png");
  const auto result =
    RunProgram({ PENUMBRA_VIEWER, files.File, "--screenshot", picture, "--size", "1000", "700" });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const auto window = ReadPNG(picture);
  CHECK(window->GetDimensions()[0] == 1000);
  CHECK(window->GetDimensions()[1] == 700);

  const std::string dark = files.PathOf("dark.png");
  const std::string unlit = files.Write("unlit.json", R"({ "volume": { "file": "shells.mhd" },
    "transferFunction": { "opacity": [[120,0],[200,0.5]], "color": [[120,0.9,0.5,0.3]] },
    "lights": [], "image": { "background": [0,0,0] } })");
  REQUIRE(RunProgram({ PENUMBRA_VIEWER, unlit, "--screenshot", dark, "--size", "1000", "700" })
            .exitStatus == 0);
  // A lit ball that fills a good part of the window differs by far more than its panels could.
  CHECK(CompareImages(window, ReadPNG(dark)).rmse > 15.0);
  CHECK(LargestLevel(window) > 150);
}

TEST_CASE("A screenshot of what cannot be opened says why and writes nothing")
{
  const ShellsScene files;
  const std::string bad = files.Write("bad.json", R"({ "volume": { "fil": "shells.mhd" } })");
  const std::string picture = files.PathOf("window.png");
  const auto before = files.Names();
  const auto result = RunProgram({ PENUMBRA_VIEWER, bad, "--screenshot", picture });
  CHECK(result.exitStatus == 2);
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("volume.fil"));
  CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
  CHECK(files.Names() == before);
}

TEST_CASE("Bad usage of the viewer is one line and exit status 2")
{
  const std::vector<std::vector<std::string>> commands = { { "--screenshot", "a.png" },
    { "scene.json", "--screenshot", "a.jpg" }, { "--size", "0", "5" }, { "--nothing" } };
  for (const auto& arguments : commands)
  {
    std::vector<std::string> command = { PENUMBRA_VIEWER };
    command.insert(command.end(), arguments.begin(), arguments.end());
    const auto result = RunProgram(command);
    CAPTURE(arguments, result.error);
    CHECK(result.exitStatus == 2);
    CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
  }
}

TEST_CASE("Without a display the viewer says so and ends")
{
  const QByteArray display = qgetenv("DISPLAY");
  qputenv("DISPLAY", ":no");
  const auto result = RunProgram({ PENUMBRA_VIEWER });
  qputenv("DISPLAY", display);
  CHECK(result.exitStatus == 1);
  CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
}
