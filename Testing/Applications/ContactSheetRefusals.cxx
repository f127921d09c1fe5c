#include "Catch.h"
#include "SheetOfColors.h"

using namespace penumbra;

using Json = nlohmann::json;

TEST_CASE("What does not describe a sheet ends with status 2, one line, and nothing written")
{
  SheetOfColors folder;
  struct Fault
  {
    std::string pointer;
    Json value;
    std::string said;
  };
  folder.Write("text.png", "no picture");
  const std::string whole = ReadAll(folder.PathOf("red.png"));
  folder.Write("cut.png", whole.substr(0, whole.size() - 40));
  std::string torn = whole;
  torn[torn.size() / 2] ^= 1;
  folder.Write("torn.png", torn);
  const std::string picture = "/rows/1/cells/0/picture";
  const std::string caption = "/rows/1/cells/0/caption";
  const std::vector<Fault> faults = {
    { "/columns", { "One" }, "rows.0.cells has 2 entries; accepted: as many as there are columns" },
    { "/columns", Json::array(), "columns has 0 entries" },
    { "/columns/1", 7, "columns.1 is 7" },
    { "/rows", Json::array(), "rows has 0 entries" },
    { "/rows/1/cells", Json::array(), "rows.1.cells has 0 entries" },
    { "/rows/0", Json::object(), "rows.0.cells is missing" },
    { "/rows/1/cells/0", Json::object(), "rows.1.cells.0.picture is missing" },
    { "/rows/1/cells/0/capton", "4 x", "rows.1.cells.0.capton" },
    { "/heading", "Title", "heading is \"Title\": unknown key" },
    { caption, 3, "rows.1.cells.0.caption is 3" },
    { caption, "3 \xc3\x97", "printable ASCII" },
    { caption, std::string(301, 'a'), "at most 300 letters" },
    { "/cellSize", { 100 }, "cellSize" },
    { "/cellSize", { 100, 8 }, "cellSize" },
    { "/cellSize", { 4096, 16384 }, "cellSize" },
    { picture, "none.png", "none.png cannot be read; accepted: a PNG file" },
    { picture, "text.png", "text.png is no whole PNG file" },
    { picture, "..", "cannot be read" },
    { picture, "torn.png", "torn.png is no whole PNG file" },
    { picture, "cut.png", "cut.png is no whole PNG file" },
  };
  const Json sound = folder.Sheet;
  folder.Write("sheet.json", "");
  const auto before = folder.Names();
  for (const Fault& fault : faults)
  {
    folder.Sheet = sound;
    folder.Sheet[Json::json_pointer(fault.pointer)] = fault.value;
    const auto result = folder.Run();
    INFO(fault.said << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(IsOneLine(result.error));
    CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring(fault.said));
    CHECK(folder.Names() == before);
  }
}

TEST_CASE("A sheet that would be too large is refused")
{
  SheetOfColors folder;
  const Json row = folder.Sheet["rows"][0];
  folder.Sheet["cellSize"] = { 100, 4096 };
  for (int i = 0; i < 3; ++i)
  {
    folder.Sheet["rows"].push_back(row);
  }
  const auto result = folder.Run();
  CHECK(result.exitStatus == 2);
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("at most 16384 each way"));
}

TEST_CASE("Wrong use of the program ends with status 2 and one line")
{
  const SheetOfColors folder;
  const std::string sheet = folder.Write("sheet.json", folder.Sheet.dump());
  struct Use
  {
    std::vector<std::string> arguments;
    std::string said;
  };
  const std::vector<Use> uses = {
    { {}, "no sheet was named" },
    { { sheet }, "no --output was named" },
    { { sheet, "--bogus" }, "--bogus" },
    { { sheet, "--output", folder.PathOf("a.mha") }, "accepted: a name that ends in .png\n" },
    { { sheet, "--output", folder.PathOf("a.jpg") }, "accepted: a name that ends in .png\n" },
    { { sheet, "--output", folder.PathOf("none/a.png") }, "folder" },
    { { sheet, "--output", folder.PathOf("red.png") }, "cannot be written too" },
    { { folder.PathOf("none.json"), "--output", folder.PathOf("a.png") }, "none.json" },
    { { folder.PathOf("red.png"), "--output", folder.PathOf("a.png") }, "not valid JSON" },
  };
  const auto before = folder.Names();
  const std::string red = ReadAll(folder.PathOf("red.png"));
  for (const Use& use : uses)
  {
    std::vector<std::string> command = { PENUMBRA_CONTACT_SHEET };
    command.insert(command.end(), use.arguments.begin(), use.arguments.end());
    const auto result = RunProgram(command);
    INFO(use.said << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(IsOneLine(result.error));
    CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring(use.said));
    CHECK(folder.Names() == before);
  }
  CHECK(ReadAll(folder.PathOf("red.png")) == red);
  CHECK(RunProgram({ PENUMBRA_CONTACT_SHEET, "--help" }).exitStatus == 0);
}
