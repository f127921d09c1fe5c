#include "Catch.h"
#include "StabilityStudy.h"
#include "TemporaryFolder.h"

#include <set>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
std::vector<StabilityRow> Run(const std::vector<StabilityCase>& cases)
{
  const TemporaryFolder folder;
  const RenderProgram program(PENUMBRA_RENDER, folder.PathOf(""));
  return RunStabilityStudy(cases, program, folder.PathOf(""), {});
}
}

TEST_CASE("Cases have names of their own")
{
  std::set<std::string> names;
  for (const StabilityCase& stability : GetStabilityCases())
  {
    CHECK(names.insert(stability.Name).second);
  }
  CHECK(names.size() > 60);
}

TEST_CASE("Every extreme case comes out as it has to")
{
  for (const StabilityRow& row : Run(GetStabilityCases()))
  {
    INFO(row.Case << ": " << row.Expected << ", but " << row.Penumbra.Words);
    CHECK(row.Penumbra.IsRight);
  }
}

TEST_CASE("What is wrong is told")
{
  std::vector<StabilityCase> cases = { GetStabilityCases().at(3), GetStabilityCases().at(3) };
  // No picture of 8 bits is that close, and a good scene is not refused.
  cases[0].Bound = 1e-6;
  cases[1].Bound = -1.0;
  const auto rows = Run(cases);
  CHECK_FALSE(rows[0].Penumbra.IsRight);
  CHECK_THAT(rows[0].Penumbra.Words, ContainsSubstring("RMSE"));
  CHECK_FALSE(rows[1].Penumbra.IsRight);
  CHECK(rows[1].Penumbra.Words == "done");
  CHECK(SummarizeStability(rows) == "0 of 2 extreme cases are right; with VTK's own mapper 0 are");
  CHECK_THAT(WriteStabilityMarkdown(rows), ContainsSubstring("**done**"));
  CHECK_THAT(WriteStabilityCsv(rows), ContainsSubstring("no,\"done\""));
  CHECK(nlohmann::json::parse(WriteStabilityJson(rows, "c"))["cases"].size() == 2);
}
