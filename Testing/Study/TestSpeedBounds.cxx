#include "Catch.h"
#include "SpeedBounds.h"
#include "SpeedGrid.h"
#include "SpeedRows.h"

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
const SpeedBound* Find(const std::vector<SpeedBound>& bounds, const std::string& name)
{
  const auto found = std::find_if(
    bounds.begin(), bounds.end(), [&](const SpeedBound& bound) { return bound.Name == name; });
  return found == bounds.end() ? nullptr : &*found;
}

double ValueOf(const std::vector<SpeedRow>& rows, const std::string& name)
{
  const std::vector<SpeedBound> bounds = JudgeSpeed(rows);
  const SpeedBound* bound = Find(bounds, name);
  REQUIRE(bound);
  return bound->Value;
}
}

TEST_CASE("Bounds of frames are medians over the scenes that they are stated for")
{
  std::vector<SpeedRow> rows = { Row("a", "unlit", 0.1), Row("b", "unlit", 0.25),
    Row("c", "unlit", 0.9), Row("a", "rays", 1.5) };
  rows.push_back(Row("d", "unlit", 0.8));
  rows.back().HasBounds = false;
  rows.push_back(Row("a", "unlit", 0.7));
  rows.back().Image = 256;
  rows.push_back(Row("what the stock mapper cannot draw", "unlit", 0.0));
  CHECK(ValueOf(rows, "unlit") == 0.25);
  CHECK(Find(JudgeSpeed(rows), "unlit")->Where == "median of 3 scenes");
  CHECK(Find(JudgeSpeed(rows), "unlit")->IsHeld());
  CHECK_FALSE(Find(JudgeSpeed(rows), "a soft shadow by rays")->IsHeld());
  CHECK_FALSE(Find(JudgeSpeed(rows), "lit"));
}

TEST_CASE("Of the techniques with a cache the cheapest that is right enough counts")
{
  const std::vector<SpeedRow> rows = { Cached("a", "volume", 0.2, 3.0),
    Cached("a", "deep-map", 0.5, 0.9), Cached("b", "deep-map", 0.9, 0.1),
    Cached("b", "volume", 0.3, 0.8), Cached("c", "volume", 0.2, 5.0),
    Cached("c", "deep-map", 0.55, 4.0) };
  CHECK(ValueOf(rows, "a soft shadow from a cache") == 0.5);
  CHECK(ValueOf(rows, "a soft shadow from a cache, on any") == 0.55);
  CHECK(ValueOf(rows, "error of cached shadows") == 5.0);
}

TEST_CASE("A cache that auto chose counts too")
{
  std::vector<SpeedRow> rows = { Cached("a", "volume", 0.5, 0.9), Cached("a", "auto", 0.3, 0.8) };
  rows[1].Technique = "opacity-map";
  CHECK(ValueOf(rows, "a soft shadow from a cache") == 0.3);
}

TEST_CASE("A cache that rays stood in for is none")
{
  std::vector<SpeedRow> rows = { Cached("a", "volume", 0.2, 0.5), Cached("a", "auto", 0.2, 0.5) };
  rows[0].Technique = rows[1].Technique = "rays";
  CHECK_FALSE(Find(JudgeSpeed(rows), "a soft shadow from a cache"));
}

TEST_CASE("More lights and more voxels are held against fewer")
{
  // One light is timed in turn with the four, and again where it is alone.
  std::vector<SpeedRow> rows = { Row("a", "auto", 0.4), Row("a", "auto", 0.8),
    Row("a", AutoOfOneLight, 0.5), Row("b", "auto", 0.1) };
  rows[1].Lights = rows[2].Lights = rows[3].Lights = 4;
  CHECK(ValueOf(rows, "four lights over one") == Approx(1.6));
  for (const int edge : { 128, 256 })
  {
    rows.push_back(Row("a", "lit", edge == 128 ? 0.2 : 0.42));
    rows.back().Edge = edge;
    rows.back().IsOwnSize = false;
  }
  CHECK(ValueOf(rows, "twice the edge") == Approx(2.1));
}

TEST_CASE("Edits are told in unlit frames of the stock mapper")
{
  // Half an unlit frame takes two seconds; so the unlit frame takes four.
  SpeedRow row = Row("a", "auto", 0.5);
  row.CpuSeconds = 2.0;
  row.LightEdit = 10.0;
  row.OpacityEdit = 14.0;
  CHECK(ValueOf({ row }, "a moved light") == 2.5);
  CHECK(ValueOf({ row }, "a changed opacity") == 3.5);
  CHECK_FALSE(Find(JudgeSpeed({ row }), "a changed opacity")->IsHeld());
}

TEST_CASE("Pictures that skipping changes are told")
{
  SpeedRow row = Row("a", "lit", 0.3);
  row.ChangedBySkipping = 2e-4;
  CHECK(ValueOf({ row }, "pixels changed by skipping, of 10000") == Approx(2.0));
  row.Variant = "unlit, 1/4 voxel";
  row.Error = PictureError{ 0.7, 0, 0, 0, 1 };
  CHECK(ValueOf({ row }, "unlit from the stock picture, at a quarter voxel") == 0.7);
}

TEST_CASE("The summary names what is missed")
{
  std::vector<SpeedRow> rows = { Row("a", "unlit", 0.25), Row("a", "lit", 0.39) };
  CHECK(SummarizeSpeed(rows).WithinBounds);
  CHECK_THAT(SummarizeSpeed(rows).Line,
    ContainsSubstring("1 scene, 2 ways") &&
      ContainsSubstring("held: unlit 0.25 (bound 0.3), lit 0.39 (bound 0.4)"));
  rows[1].Relative = 0.41;
  CHECK_FALSE(SummarizeSpeed(rows).WithinBounds);
  CHECK_THAT(SummarizeSpeed(rows).Line, ContainsSubstring("missed: lit 0.41 (more than 0.4)"));
}

TEST_CASE("Scenes of one's own have no bounds")
{
  std::vector<SpeedRow> rows = { Row("a", "lit", 9.0), Row("a", "lit", 90.0) };
  for (std::size_t at = 0; at < rows.size(); ++at)
  {
    rows[at].HasBounds = false;
    rows[at].IsOwnSize = false;
    rows[at].Edge = at == 0 ? 128 : 256;
  }
  CHECK(JudgeSpeed(rows).empty());
  CHECK(SummarizeSpeed(rows).WithinBounds);
}
