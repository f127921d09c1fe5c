#include "Catch.h"
#include "ErrorReport.h"
#include "ErrorRows.h"

#include <cmath>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("On the Pareto front no row is both faster and better than another")
{
  const std::vector<ErrorRow> rows = { Row("a", 1.0, 4.0, 1.0), Row("b", 1.0, 5.0, 2.0),
    Row("b", 0.5, 1.0, 3.0), Row("a", 0.5, 2.0, 3.5), Row("a", 0.25, 0.5, 9.0) };
  const auto front = ParetoFront(rows, "scene");
  REQUIRE(front.size() == 3);
  CHECK(front[0].CpuSeconds == 1.0);
  CHECK(front[1].CpuSeconds == 3.0);
  CHECK(front[2].CpuSeconds == 9.0);
  CHECK(ParetoFront(rows, "another").empty());
}

TEST_CASE("Tables have a line for every row")
{
  ErrorStudyResult result;
  result.Rows = { Row("penumbra rays", 0.5, 0.7, 1.0), Row("vtk", 2.0, 9.0, 0.5) };
  result.Notes = { "scene, vtk, step 1: failed" };
  const std::string csv = WriteErrorCsv(result);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
  CHECK_THAT(csv, ContainsSubstring("scene,penumbra rays,0.5,0.7,"));
  const auto json = nlohmann::json::parse(WriteErrorJson(result, "penumbra-study error"));
  CHECK(json["rows"].size() == 2);
  CHECK(json["rows"][1]["rmse"] == 9.0);
  CHECK(json["command"] == "penumbra-study error");
  const std::string markdown = WriteErrorMarkdown(result);
  CHECK_THAT(markdown, ContainsSubstring("| penumbra rays | 1/2 | 0.70 | - |"));
  CHECK_THAT(markdown, ContainsSubstring("step 1: failed"));
}

TEST_CASE("Charts show every row of their scene, and the front")
{
  ErrorStudyResult result;
  result.Rows = RowsOfOrder(2.0, 0.2);
  result.Rows.push_back(Row("vtk", 1.0, 9.0, 0.5));
  const ChartDescription time = ChartOfTime(result, "scene");
  REQUIRE(time.Series.size() == GetStudyVariants().size());
  CHECK(time.Series[0].X.size() == 7);
  CHECK(time.Series[0].X[0] == result.Rows[0].Relative);
  CHECK(time.Guides.size() == 1);
  const ChartDescription step = ChartOfStep(result, "scene");
  CHECK_THAT(step.Title, ContainsSubstring("order 2.0"));
  // The guide falls with the square of the step.
  REQUIRE(step.Guides.size() == 1);
  CHECK(step.Guides[0].Y[0] / step.Guides[0].Y[1] == Approx(std::pow(64.0, 2.0)));
}

TEST_CASE("The summary tells the bounds that are missed")
{
  ErrorStudyResult result;
  result.Rows = { Row("penumbra rays", 0.5, 0.9, 1.0), Row("penumbra rays", 0.25, 0.45, 4.0),
    Row("vtk", 0.5, 50.0, 1.0) };
  CHECK(Summarize(result).WithinBounds);
  result.Rows[0].Error.RootMeanSquare = 1.1;
  CHECK_FALSE(Summarize(result).WithinBounds);
  CHECK_THAT(Summarize(result).Line,
    ContainsSubstring("1.10 of 255 at the default step (scene, penumbra rays"));
  result.Rows[0].Error.RootMeanSquare = 0.9;
  result.Rows.push_back(Row("penumbra auto", 0.5, 1.2, 0.5));
  CHECK_FALSE(Summarize(result).WithinBounds);
  CHECK_THAT(Summarize(result).Line, ContainsSubstring("1.20 of 255"));
  result.Rows.pop_back();
  result.Rows[1].Error.RootMeanSquare = 0.55;
  CHECK_FALSE(Summarize(result).WithinBounds);
}
