#include "Catch.h"
#include "SpeedStudy.h"
#include "StudyScenes.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
SpeedCell Balls(const TemporaryFolder& folder, int edge = 0, int lights = 1)
{
  const StudyScene scene = WriteAnalyticScene("two-balls", 24, folder.PathOf("scenes"));
  return { { scene.Name, scene.File, true }, edge, 32, lights };
}

SpeedStudyResult Run(const std::vector<SpeedCell>& cells, const TemporaryFolder& folder)
{
  return RunSpeedStudy(cells, { folder.PathOf(""), {}, {} });
}

const SpeedRow* Find(const SpeedStudyResult& result, const std::string& variant)
{
  const auto found = std::find_if(result.Rows.begin(), result.Rows.end(),
    [&](const SpeedRow& row) { return row.Variant == variant; });
  return found == result.Rows.end() ? nullptr : &*found;
}
}

TEST_CASE("Memory is told of few pixels, but by auto of those that are timed")
{
  const TemporaryFolder folder;
  SpeedCell cell = Balls(folder);
  cell.Image = 512;
  // In penumbra-render's place: the scenes that it is given are kept.
  const std::string file =
    folder.Write("program", "#!/bin/sh\ncp \"$1\" \"${0%program}seen-$$.json\"\nexit 1\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  const RenderProgram program(file, folder.PathOf(""));
  const SpeedStudyResult result =
    RunSpeedStudy({ cell }, { folder.PathOf(""), { {}, &program }, {} });
  int few = 0;
  int whole = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.PathOf("")))
  {
    if (entry.path().filename().string().rfind("seen-", 0) != 0)
    {
      continue;
    }
    const auto scene = nlohmann::json::parse(std::ifstream(entry.path()));
    const int edge = scene["image"]["size"][0];
    few += edge == 16;
    whole += edge == 512 && scene["shadows"]["technique"] == "auto" &&
      scene["lights"][0]["shadow"] == "soft";
  }
  CHECK(whole == 1);
  CHECK(few == static_cast<int>(result.Rows.size()) - 1);
  CHECK_FALSE(Find(result, "auto")->PeakMemory);
}

TEST_CASE("A small grid is drawn by every technique that there is")
{
  const TemporaryFolder folder;
  SpeedCell cell = Balls(folder);
  cell.Image = 512;
  const RenderProgram program(PENUMBRA_RENDER, folder.PathOf(""));
  const SpeedStudyResult result =
    RunSpeedStudy({ cell }, { folder.PathOf(""), { {}, &program }, {} });
  for (const char* variant : { "vtk, unlit", "vtk, lit", "unlit", "lit", "rays", "volume",
         "deep-map", "opacity-map", "auto", "map, hard" })
  {
    CAPTURE(variant);
    const SpeedRow* row = Find(result, variant);
    REQUIRE(row);
    CHECK(row->CpuSeconds > 0.0);
    CHECK(row->First > 0.0);
    CHECK(row->Edge == 24);
    CHECK(row->Voxels == 24 * 24 * 24);
    CHECK(*row->PeakMemory > 1000000);
    CHECK(row->ChangedBySkipping.value_or(0.0) <= 1e-4);
  }
  CHECK(*Find(result, "auto")->LightEdit > 0.0);
  CHECK(*Find(result, "auto")->OpacityEdit > 0.0);
  CHECK_FALSE(Find(result, "rays")->LightEdit);
  CHECK(Find(result, "vtk, unlit")->Relative == 1.0);
  CHECK(Find(result, "unlit")->Technique == "none");
  // 24 voxels make several bricks along each edge, and those in the corners are empty.
  CHECK(Find(result, "unlit")->Counts.at("bricks") > 8);
  CHECK(Find(result, "unlit")->Counts.at("occupied bricks") <
    Find(result, "unlit")->Counts.at("bricks"));
  CHECK(Find(result, "vtk, lit")->Counts.count("samples") == 0);
  // All that is lit was sampled, and shadows alone take shadow steps.
  CHECK(Find(result, "unlit")->Counts.at("shaded samples") == 0.0);
  CHECK(Find(result, "lit")->Counts.at("shaded samples") > 0.0);
  CHECK(
    Find(result, "lit")->Counts.at("samples") > Find(result, "lit")->Counts.at("shaded samples"));
  CHECK(Find(result, "lit")->Counts.at("shadow steps") == 0.0);
  CHECK(Find(result, "rays")->Counts.at("shadow steps") >
    Find(result, "volume")->Counts.at("shadow steps"));
  // 8-bit pictures of one integral at 4 steps a voxel: rounding, and what is left of the steps.
  CHECK(Find(result, "unlit, 1/4 voxel")->Error->RootMeanSquare < 1.0);
  CHECK_FALSE(Find(result, "lit")->Error);
}

TEST_CASE("A shadow is held against rays with half the shadow step")
{
  const TemporaryFolder folder;
  const SpeedStudyResult result = Run({ Balls(folder) }, folder);
  const SpeedRow* rays = Find(result, "rays");
  REQUIRE(rays);
  CHECK(rays->Technique == "rays");
  // Shadow steps of 5 lengths where the balls' borders are 5 thick.
  CHECK(rays->Error->RootMeanSquare > 0.0);
  CHECK(rays->Error->RootMeanSquare < 4.0);
}

TEST_CASE("What skipping changes is told of scenes that bounds are stated for")
{
  const TemporaryFolder folder;
  SpeedCell cell = Balls(folder);
  cell.Image = 512;
  cell.Scene.HasBounds = GENERATE(false, true);
  const SpeedStudyResult result = Run({ cell }, folder);
  CHECK(Find(result, "lit")->ChangedBySkipping.has_value() == cell.Scene.HasBounds);
}

TEST_CASE("What was measured is not measured again, unless its scene has changed")
{
  const TemporaryFolder folder;
  const SpeedCell first = Balls(folder);
  const SpeedStudyResult before = Run({ first }, folder);
  const SpeedCell second = Balls(folder, 0, 2);
  const SpeedStudyResult after = Run({ first, second }, folder);
  CHECK(after.Rows.size() == before.Rows.size() + GetSpeedVariants(second, false).size());
  // No two measurements are the same to the last bit.
  CHECK(after.Rows[0].CpuSeconds == before.Rows[0].CpuSeconds);
  CHECK(after.Rows[0].First == before.Rows[0].First);
  CHECK(after.Rows.back().Lights == 2);
  folder.Write("scenes/two-balls.json", R"({ "volume": { "file": "two-balls.vti" } })");
  CHECK(Run({ first }, folder).Rows[0].First != before.Rows[0].First);
  EndSpeedStudy(folder.PathOf(""));
  CHECK(folder.Names() == std::vector<std::string>{ "scenes" });
}

TEST_CASE("A scene that cannot be read is a note, and nothing to draw an error")
{
  const TemporaryFolder folder;
  SpeedCell broken = Balls(folder);
  broken.Scene = { "broken", folder.Write("broken.json", "{") };
  const SpeedStudyResult result = Run({ broken, Balls(folder) }, folder);
  CHECK_FALSE(result.Rows.empty());
  CHECK_THAT(result.Notes[0], ContainsSubstring("broken, 32 pixels, 1 light is left out: "));
  CHECK_THROWS_WITH(Run({ broken }, folder), ContainsSubstring("nothing could be drawn: broken"));
  CHECK_THROWS_WITH(Run({}, folder), ContainsSubstring("no scenes"));
}
