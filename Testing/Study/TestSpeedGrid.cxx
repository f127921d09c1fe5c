#include "Catch.h"
#include "SpeedMeasurement.h"
#include "SpeedRendering.h"
#include "SpeedScenes.h"
#include "SpeedVoxels.h"
#include "TemporaryFolder.h"

#include <vtkImageData.h>

#include <cmath>
#include <set>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
SpeedCell Tree(const TemporaryFolder& folder, int edge, int lights)
{
  const StudyScene scene = WriteAnalyticScene("tree", 9, folder.PathOf(""));
  return { { scene.Name, scene.File }, edge, 32, lights };
}
}

TEST_CASE("The grid has every cell once, and the whole grid has more")
{
  const std::vector<SpeedScene> scenes = { { "a", "a.json", true, false },
    { "b", "b.json", false, true } };
  const auto cellsOf = [&](bool full)
  {
    std::set<std::string> cells;
    for (const SpeedCell& cell : MakeSpeedGrid(scenes, full))
    {
      INFO(NameOfCell(cell));
      CHECK(cells.insert(NameOfCell(cell)).second);
    }
    return cells;
  };
  const auto cells = cellsOf(false);
  CHECK(cells.count("a, 512 pixels, 1 light"));
  CHECK(cells.count("a, 512 pixels, 4 lights"));
  CHECK_FALSE(cells.count("a, 64 voxels, 512 pixels, 1 light"));
  CHECK(cells.count("b, 64 voxels, 512 pixels, 1 light"));
  CHECK(cells.count("b, 512 pixels, 8 lights"));
  CHECK(cells.count("b, 128 pixels, 1 light"));
  const auto all = cellsOf(true);
  CHECK(std::includes(all.begin(), all.end(), cells.begin(), cells.end()));
  CHECK(all.count("a, 512 voxels, 512 pixels, 8 lights"));
  CHECK(all.count("a, 1024 pixels, 1 light"));
}

TEST_CASE("Every variant has a name of its own, the stock mapper's unlit frame the first")
{
  for (const bool full : { false, true })
  {
    std::set<std::string> names;
    const auto variants = GetSpeedVariants({ { "a", "a.json" } }, full);
    for (const SpeedVariant& variant : variants)
    {
      CHECK(names.insert(variant.Name).second);
    }
    CHECK(variants.front().Name == StockUnlit);
    CHECK(names.count("volume x 1/2") == (full ? 1 : 0));
  }
}

TEST_CASE("Shadows of one light are held against a truth, those of many are timed alone")
{
  for (const int lights : { 1, 4 })
  {
    for (const SpeedVariant& variant :
      GetSpeedVariants({ { "a", "a.json" }, 64, 512, lights }, true))
    {
      CAPTURE(variant.Name, lights);
      const bool isUnshadowed = variant.Name.find("lit") != std::string::npos;
      CHECK(variant.Truth.has_value() == (lights == 1 && !isUnshadowed));
    }
  }
}

TEST_CASE("Edits are of one soft shadow in the plain cell, of all that is kept in the whole grid")
{
  const SpeedScene scene = { "a", "a.json", true, true };
  const SpeedCell cell = GENERATE_COPY(
    values<SpeedCell>({ { scene }, { scene, 64 }, { scene, 0, 256 }, { scene, 0, 512, 4 } }));
  const bool full = GENERATE(false, true);
  for (const SpeedVariant& variant : GetSpeedVariants(cell, full))
  {
    CAPTURE(NameOfCell(cell), variant.Name, full);
    const bool isKept = variant.Name.find("lit") == std::string::npos &&
      variant.Name.find("rays") == std::string::npos;
    const bool isHard = variant.Name.find("hard") != std::string::npos;
    CHECK(variant.HasEdits == (isKept && (full || (cell.IsPlain() && !isHard))));
  }
}

TEST_CASE("Scenes without axes have the techniques with one light, and auto with more")
{
  const auto namesOf = [](bool hasAxes, int lights, bool full)
  {
    std::set<std::string> names;
    for (const SpeedVariant& variant :
      GetSpeedVariants({ { "a", "a.json", true, hasAxes }, 0, 512, lights }, full))
    {
      names.insert(variant.Name);
    }
    return names;
  };
  CHECK(namesOf(false, 4, false) ==
    std::set<std::string>{ StockUnlit, "unlit", "lit", "auto", AutoOfOneLight });
  for (const auto& names :
    { namesOf(false, 1, false), namesOf(true, 4, false), namesOf(false, 4, true) })
  {
    CHECK(names.count("auto") == 1);
    CHECK(names.count("volume") == 1);
    CHECK(names.count("vtk, lit") == 1);
  }
}

TEST_CASE("Four lights with bounds, and one of them, are timed more often than all else")
{
  const TemporaryFolder folder;
  const int lights = GENERATE(1, 4);
  for (const bool hasBounds : { false, true })
  {
    SpeedCell cell = Tree(folder, 0, lights);
    cell.Scene.HasBounds = hasBounds;
    cell.Image = 512;
    for (const SpeedVariant& variant : GetSpeedVariants(cell, false))
    {
      CAPTURE(hasBounds, variant.Name);
      const bool isCompared =
        hasBounds && lights == 4 && (variant.Name == "auto" || variant.Name == AutoOfOneLight);
      CHECK((variant.Rounds == RoundsOfFourLights) == isCompared);
      CHECK(variant.Request.HasOneLight == (variant.Name == AutoOfOneLight));
    }
  }
}

TEST_CASE("Steps are voxels, and lights copies of the first that are as bright together")
{
  const TemporaryFolder folder;
  const SpeedCell cell = Tree(folder, 22, 4);
  const SceneVoxels voxels = ReadSpeedVoxels(cell, {});
  const SceneDescription scene = DescribeSpeedScene(
    cell, { { "lights.0.shadow=hard", "shadows.resolution=0.5" }, 0.5, 2.0 }, voxels);
  CHECK(*scene.SampleDistance == Approx(1.5));
  CHECK(*scene.Shadows.SampleDistance == Approx(6.0));
  CHECK(scene.Shadows.Resolution == 0.5);
  CHECK(scene.Image.Size == std::array<int, 2>{ 32, 32 });
  REQUIRE(scene.Lights.size() == 4);
  Vector3 sum = { 0.0, 0.0, 0.0 };
  for (const LightDescription& light : scene.Lights)
  {
    CHECK(light.Intensity == 0.25);
    CHECK(light.Shadow == ShadowKind::Hard);
    sum = Sum(sum, light.Direction);
  }
  // Evenly about the view's up, which is z, only what is along it remains.
  CHECK(std::hypot(sum[0], sum[1]) < 1e-12);
  CHECK(sum[2] == Approx(4.0 * scene.Lights[0].Direction[2]));
  const SceneDescription alone = DescribeSpeedScene(cell, { {}, 1.0, 1.0, true }, voxels);
  REQUIRE(alone.Lights.size() == 1);
  CHECK(alone.Lights[0].Intensity == 1.0);
}

TEST_CASE("Scenes whose volume is not there are left out and named")
{
  const TemporaryFolder folder;
  folder.Write("fetched/bonsai.mhd", "");
  const SpeedSceneList list =
    WriteSpeedScenes({ folder.PathOf("scenes"), PENUMBRA_DATA, folder.PathOf("fetched"), 8 });
  REQUIRE(list.Scenes.size() == 4);
  CHECK(list.Scenes[0].Name == "bonsai");
  CHECK(list.Scenes[0].HasBounds);
  CHECK(list.Scenes[1].Name == "tree");
  CHECK_FALSE(list.Scenes[1].HasBounds);
  CHECK(list.Notes.size() == 5);
  CHECK_THAT(list.Notes[0], ContainsSubstring("engine is left out: there is no"));
  CHECK_THAT(list.Notes[0], !ContainsSubstring(folder.PathOf("")));
}
