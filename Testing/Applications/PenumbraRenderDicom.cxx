#include "Catch.h"
#include "DicomSlices.h"
#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <filesystem>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
DicomSlices OtherSeries(int count)
{
  auto slices = Slices(count);
  for (auto& slice : slices)
  {
    slice.elements["SeriesInstanceUID"] = "1.2.3.4.200";
    slice.elements["SeriesDescription"] = "other";
  }
  return slices;
}

nlohmann::json ReportOf(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
  arguments.insert(arguments.end(),
    { "--set", "image.size=[16,16]", "--output", folder.PathOf("p.png"), "--report",
      folder.PathOf("r.json") });
  const auto result = RunPenumbraRender(arguments);
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  return nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
}

bool AnyMentions(const nlohmann::json& warnings, const std::string& text)
{
  for (const auto& warning : warnings)
  {
    if (warning.get<std::string>().find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
}

TEST_CASE("A folder of slices is rendered where they lie")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(5), "slices/");
  folder.Write("slices/notes.txt", "not an image");
  const auto report = ReportOf(folder, { folder.PathOf("slices") });
  CHECK(report["volume"]["dims"] == nlohmann::json({ 4, 3, 5 }));
  CHECK(report["volume"]["spacing"] == nlohmann::json({ 0.75, 0.5, 2.5 }));
  CHECK(report["volume"]["origin"] == nlohmann::json({ -10.0, 20.0, 30.0 }));
  CHECK(report["volume"]["direction"] == nlohmann::json({ 1., 0., 0., 0., 1., 0., 0., 0., 1. }));
  CHECK(report["volume"]["range"] == nlohmann::json({ 0.0, 1623.0 }));
  CHECK(report["warnings"].empty());
}

TEST_CASE("One file is one slice, and it is said that there may be more")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(2), "slices/");
  std::filesystem::rename(folder.PathOf("slices/1.dcm"), folder.PathOf("slices/IM0001"));
  const auto report = ReportOf(folder, { folder.PathOf("slices/IM0001") });
  CHECK(report["volume"]["dims"] == nlohmann::json({ 4, 3, 1 }));
  CHECK(AnyMentions(report["warnings"], "folder"));
}

TEST_CASE("What is wrong with a series is told in the report")
{
  const TemporaryFolder folder;
  auto slices = Slices(6);
  slices.erase(slices.begin() + 2);
  WriteSlices(folder, slices, "slices/");
  const auto report = ReportOf(folder, { folder.PathOf("slices") });
  CHECK(report["volume"]["dims"][2] == 6);
  CHECK(AnyMentions(report["warnings"], "1 slice missing"));
}

TEST_CASE("A scene chooses one of several series; without a choice the others are named")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(4), "slices/a/");
  WriteSlices(folder, OtherSeries(3), "slices/b/");
  const auto largest = ReportOf(folder, { folder.PathOf("slices") });
  CHECK(largest["volume"]["dims"][2] == 4);
  CHECK(AnyMentions(largest["warnings"], "1.2.3.4.200"));

  const std::string scene =
    folder.Write("s.json", R"({ "volume": { "file": "slices", "series": "1.2.3.4.200" } })");
  const auto chosen = ReportOf(folder, { scene, "--save-scene", folder.PathOf("elsewhere.json") });
  CHECK(chosen["volume"]["dims"][2] == 3);
  const auto saved = nlohmann::json::parse(ReadAll(folder.PathOf("elsewhere.json")));
  CHECK(saved["volume"]["series"] == "1.2.3.4.200");
  CHECK(ReportOf(folder, { folder.PathOf("elsewhere.json") })["volume"] == chosen["volume"]);

  const auto refused = RunPenumbraRender({ folder.PathOf("slices"), "--set",
    "volume.series=\"9.9\"", "--output", folder.PathOf("none.png") });
  CHECK(refused.exitStatus == 2);
  CHECK_THAT(refused.error, ContainsSubstring("9.9") && ContainsSubstring("1.2.3.4.200"));
}

TEST_CASE("A mask may be DICOM too")
{
  const TemporaryFolder folder;
  WriteSlices(folder, Slices(3), "slices/");
  auto masks = Slices(3);
  for (auto& mask : masks)
  {
    mask.stored = [](int, int, int) { return 0; };
  }
  WriteSlices(folder, masks, "mask/");
  ReportOf(folder, { folder.PathOf("slices"), "--set", "volume.mask=" + folder.PathOf("mask") });
}

TEST_CASE("Damaged DICOM is refused in one line, and nothing is left behind")
{
  const TemporaryFolder folder;
  const std::string whole = Slice(0).File();
  folder.Write("cut.dcm", whole.substr(0, whole.size() - 5));
  folder.Write("header.dcm", whole.substr(0, 200));
  folder.Write("text.dcm", "no DICOM at all, but a text of some length");
  folder.Write("empty/notes.txt", "a folder without images");
  for (const char* name : { "cut.dcm", "header.dcm", "text.dcm", "empty" })
  {
    INFO(name);
    const auto before = folder.Names();
    const auto result =
      RunPenumbraRender({ folder.PathOf(name), "--output", folder.PathOf("p.png") });
    INFO(result.error);
    CHECK(result.exitStatus == 2);
    CHECK(result.error.find('\n') == result.error.size() - 1);
    CHECK_THAT(result.error, ContainsSubstring(name));
    CHECK(folder.Names() == before);
  }
}

TEST_CASE("Names of patients are neither printed nor stored")
{
  const TemporaryFolder folder;
  auto slices = Slices(4);
  slices.erase(slices.begin() + 1); // so that there is something to warn of
  for (auto& slice : slices)
  {
    slice.elements["PatientName"] = "Doe^Jane";
    slice.elements["PatientID"] = "Doe-4711";
  }
  WriteSlices(folder, slices, "slices/");
  const auto result = RunPenumbraRender({ folder.PathOf("slices"), "--set", "image.size=[16,16]",
    "--explain", "--output", folder.PathOf("p.png"), "--report", folder.PathOf("r.json"),
    "--save-scene", folder.PathOf("s.json") });
  REQUIRE(result.exitStatus == 0);
  for (const std::string& text : { result.output, result.error, ReadAll(folder.PathOf("p.png")),
         ReadAll(folder.PathOf("r.json")), ReadAll(folder.PathOf("s.json")) })
  {
    CHECK(text.find("Doe") == std::string::npos);
  }
}
