#include "BrightCorner.h"
#include "Catch.h"
#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

using namespace penumbra;

TEST_CASE("Help and version go to stdout with status 0")
{
  const auto help = RunPenumbraRender({ "--help" });
  CHECK(help.exitStatus == 0);
  CHECK_THAT(help.output, Catch::Matchers::ContainsSubstring("--save-scene"));
  const auto version = RunPenumbraRender({ "--version" });
  CHECK(version.exitStatus == 0);
  CHECK_THAT(version.output, Catch::Matchers::ContainsSubstring("VTK"));
}

TEST_CASE("The report has every documented key, and explaining tells the requirements")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender({ folder.Scene, "--set", "shade=true", "--set",
    "lights.0.shadow=hard", "--frames", "3", "--report", folder.PathOf("r.json"), "--explain" });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  for (const char* key :
    { "vtkVersion", "openglRenderer", "volume", "firstFrameSeconds", "frameSeconds",
      "frameCpuSeconds", "medianFrameSeconds", "shadowUpdateSeconds", "brightness", "reference",
      "technique", "techniqueReason", "keptShadows", "requirements", "emptySpace",
      "gradientTexture", "rayCounts", "leftOut", "choices", "warnings", "peakMemoryBytes" })
  {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["volume"]["dims"] == std::vector<int>{ 8, 8, 8 });
  CHECK(report["volume"]["scalarType"] == "uint8");
  CHECK(report["volume"]["range"] == std::vector<double>{ 0.0, 255.0 });
  auto seconds = report["frameSeconds"].get<std::vector<double>>();
  REQUIRE(seconds.size() == 3);
  std::sort(seconds.begin(), seconds.end());
  CHECK(seconds[0] > 0.0);
  CHECK(report["medianFrameSeconds"] == seconds[1]);
  CHECK(report["frameCpuSeconds"].size() == 3);
  CHECK(report["technique"] == "rays");
  CHECK(report["requirements"]["hard shadows"] == "1");
  CHECK(report["peakMemoryBytes"] > 1000000);
  CHECK(report["keptShadows"].is_null());
  CHECK(report["rayCounts"].is_null());
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("hard shadows"));
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("leaves out"));
}

TEST_CASE("What the stock mapper leaves out is told once, on stderr and in the report")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender(
    { folder.Scene, "--set", "renderer=vtk", "--set", "lights=[{},{},{},{},{},{},{}]", "--set",
      "shade=true", "--frames", "2", "--report", folder.PathOf("r.json") });
  CHECK(result.exitStatus == 0);
  CHECK(IsOneLine(result.error));
  CHECK(result.error.rfind("warning: ", 0) == 0);
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  CHECK(report["warnings"].size() == 1);
}

TEST_CASE("What happens to the voxels is told once, on stderr and in the report")
{
  const TemporaryFolder folder;
  std::vector<float> voxels = { 0, 1, 2, std::nanf(""), 4, 5, 6, 7 };
  folder.Write("v.raw", std::string(reinterpret_cast<const char*>(voxels.data()), 32));
  const auto result =
    RunPenumbraRender({ folder.PathOf("v.raw"), "--set", "volume.dimensions=[2,2,2]", "--set",
      "volume.scalarType=float32", "--frames", "2", "--report", folder.PathOf("r.json") });
  CHECK(result.exitStatus == 0);
  CHECK(IsOneLine(result.error));
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  REQUIRE(report["warnings"].size() == 1);
  CHECK_THAT(report["warnings"][0].get<std::string>(), Catch::Matchers::ContainsSubstring("NaN"));
  CHECK(report["volume"]["range"] == std::vector<double>{ 0.0, 7.0 });
}
