#include "Catch.h"
#include "StudyLog.h"
#include "TemporaryFolder.h"

#include <fstream>

using namespace penumbra;

namespace
{
void Append(const std::string& file, const std::string& text)
{
  std::ofstream(file, std::ios::app) << text;
}
}

TEST_CASE("A log knows what was measured before")
{
  const TemporaryFolder folder;
  const std::string file = folder.PathOf("log.jsonl");
  StudyLog first(file, "1");
  CHECK_FALSE(first.Find("a"));
  CHECK(first.Add("a", { { "x", 3 } })["x"] == 3);
  first.Add("b", { { "x", 4 } });
  const StudyLog second(file, "1");
  REQUIRE(second.Find("a"));
  CHECK((*second.Find("a"))["x"] == 3);
  CHECK((*second.Find("b"))["x"] == 4);
  CHECK_FALSE(second.Find("c"));
}

TEST_CASE("Measurements of another version do not count")
{
  const TemporaryFolder folder;
  const std::string file = folder.PathOf("log.jsonl");
  StudyLog(file, "1").Add("a", { { "x", 3 } });
  CHECK_FALSE(StudyLog(file, "2").Find("a"));
  CHECK(StudyLog(file, "1").Find("a"));
}

TEST_CASE("A line that was cut off is left out, and what follows is not lost")
{
  const TemporaryFolder folder;
  const std::string file = folder.PathOf("log.jsonl");
  StudyLog(file, "1").Add("a", { { "x", 3 } });
  Append(file, R"({"key":"b","measure)");
  StudyLog(file, "1").Add("c", { { "x", 5 } });
  const StudyLog log(file, "1");
  CHECK(log.Find("a"));
  CHECK_FALSE(log.Find("b"));
  CHECK(log.Find("c"));
}

TEST_CASE("A log that cannot be written says so")
{
  CHECK_THROWS_WITH(StudyLog("/nowhere/log.jsonl", "1").Add("a", {}),
    Catch::Matchers::ContainsSubstring("/nowhere/log.jsonl cannot be written"));
}
