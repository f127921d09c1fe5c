#include "Catch.h"
#include "SpeedCharts.h"
#include "SpeedMarkdown.h"
#include "SpeedRenderingReport.h"
#include "SpeedReport.h"
#include "SpeedRows.h"

#include <nlohmann/json.hpp>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
SpeedStudyResult Result(const std::vector<SpeedRow>& rows)
{
  return { rows, { "map is left out: why" }, "a driver" };
}

SpeedRow Counted(SpeedRow row)
{
  row.Counts = { { "samples", 123456.0 } };
  row.PeakMemory = 5000000000;
  return row;
}
}

TEST_CASE("A row is the same after it was written and read")
{
  const SpeedRow row = Counted(Cached("a", "volume", 0.2, 0.5));
  const nlohmann::json json = row;
  CHECK(nlohmann::json(json.get<SpeedRow>()) == json);
  CHECK(json["peakMemoryBytes"] == 5000000000);
  CHECK(json["changedBySkipping"].is_null());
}

TEST_CASE("What a rendering reports is taken, and what it does not is left out")
{
  SpeedRow row = Row("a", "volume", 0.5);
  ReadReport({ { "technique", "volume" }, { "gradientTexture", nullptr },
               { "keptShadows", { { "bytes", 4096 }, { "resolution", 0.5 } } } },
    row);
  CHECK(row.Technique == "volume");
  CHECK(row.Resolution == 0.5);
  CHECK(row.Counts == std::map<std::string, double>{ { "shadow bytes", 4096.0 } });
  ReadReport({ { "technique", "none" }, { "keptShadows", nullptr } }, row);
  CHECK(row.Counts.empty());
  CHECK(SkipsEmptySpace({ { "requirements", { { "empty-space skipping", "yes" } } } }));
  CHECK_FALSE(SkipsEmptySpace({ { "requirements", { { "empty-space skipping", "no" } } } }));
  CHECK_FALSE(SkipsEmptySpace({ { "requirements", { { "colour", "yes" } } } }));
}

TEST_CASE("Speed tables have a line for every row, and a column for what is counted")
{
  SpeedRow withoutStock = Row("b", "unlit", 0.25);
  withoutStock.HasBounds = false;
  withoutStock.Relative = 0.0;
  const auto rows = { Row("a", "unlit", 0.25), Counted(Cached("a", "volume", 0.5, 0.75)),
    withoutStock };
  const std::string csv = WriteSpeedCsv(Result(rows));
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 4);
  CHECK_THAT(csv, ContainsSubstring("peak_memory_bytes,samples\n"));
  CHECK_THAT(
    csv, ContainsSubstring("\"volume\",volume,1,0.5,0.25,0.5,0,1,1.5,0.75,2,,5000000000,"));
  const auto json = nlohmann::json::parse(WriteSpeedJson(Result(rows), "penumbra-study speed"));
  CHECK(json["rows"].size() == 3);
  CHECK(json["command"] == "penumbra-study speed");
  CHECK(json["openglRenderer"] == "a driver");
  CHECK(json["machine"]["processors"] > 0);
  CHECK(json["bounds"][0]["held"] == true);
  const std::string markdown = WriteSpeedMarkdown(Result(rows));
  CHECK_THAT(markdown, ContainsSubstring("| unlit | 0.25 | 0.3 | median of 1 scene | held |"));
  CHECK_THAT(markdown,
    ContainsSubstring(
      "| volume | 0.50 | 0.500 | 0.00 | 1.00 | 1.50 | 0.75 | 2.0 | - | 5000 | 123456 |"));
  CHECK_THAT(markdown,
    ContainsSubstring("| a | 256 | 512 | 1 | 0.25 | 0.50 |") &&
      ContainsSubstring("| b | 256 | 512 | 1 | - | - |"));
  CHECK_THAT(markdown, ContainsSubstring("map is left out: why"));
}

TEST_CASE("The thesis' cases stand beside its figures, in own unlit frames")
{
  const auto rows = { Row("ct", "unlit", 0.2), Row("ct", "lit", 0.3), Row("ct", "rays", 0.5),
    Row("skull", "unlit", 0.1) };
  const std::string markdown = WriteSpeedMarkdown(Result(rows));
  CHECK_THAT(markdown,
    ContainsSubstring("| ct | 1.00 (0.20) | 1.50 (0.30) | 2.50 (0.50) | - | - | 1, 1.08, 2.1 |"));
  CHECK_THAT(markdown, ContainsSubstring("| skull | 1.00 (0.10) | - | - | - | - | 1, 1, 2.6 |"));
  CHECK_THAT(WriteSpeedMarkdown(Result({ Row("a", "unlit", 0.2) })), !ContainsSubstring("thesis"));
}

TEST_CASE("The calibration has every shadow with its error and costs, and nothing else")
{
  std::vector<SpeedRow> rows = { Row("a", "lit", 0.25), Cached("a", "volume", 0.5, 0.75),
    Cached("a", "volume", 0.5, 0.75) };
  rows[2].Lights = 4;
  rows.push_back(Cached("a", "rays", 0.8, 0.1));
  rows[3].LightEdit.reset();
  const auto json = nlohmann::json::parse(WriteSpeedCalibration(Result(rows), "c"));
  REQUIRE(json["measurements"].size() == 2);
  const auto& measurement = json["measurements"][0];
  CHECK(measurement["technique"] == "volume");
  CHECK(measurement["resolution"] == 1.0);
  CHECK(measurement["rmse"] == 0.75);
  CHECK(measurement["frame"] == 0.5);
  CHECK(measurement["lightEdit"] == 1.0);
  CHECK(measurement["opacityEdit"] == 1.5);
  CHECK(json["measurements"][1]["lightEdit"] == Approx(0.8));
}

TEST_CASE("Charts run along one axis each")
{
  std::vector<SpeedRow> rows;
  for (const int edge : { 256, 64, 128 })
  {
    rows.push_back(Row("a", "lit", 0.001 * edge));
    rows.back().Edge = edge;
    rows.back().IsOwnSize = false;
  }
  for (const int lights : { 1, 2, 4 })
  {
    rows.push_back(Row("a", "rays", lights));
    rows.back().Lights = lights;
  }
  rows.push_back(Row("b", "lit", 1.0));
  rows.push_back(rows.back());
  rows.back().Lights = 4;
  const std::vector<SpeedChart> charts = MakeSpeedCharts(rows);
  REQUIRE(charts.size() == 2);
  CHECK(charts[0].File == "a-cost-over-edge");
  CHECK(charts[0].Chart.Series[0].X == std::vector<double>{ 64.0, 128.0, 256.0 });
  CHECK(charts[0].Chart.Series[0].Y == std::vector<double>{ 0.064, 0.128, 0.256 });
  CHECK(charts[0].Chart.Guides[0].Y[1] == Approx(0.256));
  CHECK(charts[1].File == "a-cost-over-lights");
  CHECK(charts[1].Chart.Series.size() == 1);
}
