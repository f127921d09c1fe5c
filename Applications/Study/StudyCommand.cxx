#include "StudyCommand.h"

#include "ErrorReport.h"
#include "InputError.h"
#include "ProgramArguments.h"
#include "ProgramFolder.h"
#include "ProgressLine.h"
#include "SceneFile.h"
#include "SpeedBounds.h"
#include "SpeedCharts.h"
#include "SpeedMarkdown.h"
#include "SpeedReport.h"
#include "SpeedScenes.h"
#include "StabilityStudy.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;

struct StudyWords
{
  std::string Study;
  std::vector<std::string> Scenes;
  std::string Output = "study";
  /// Empty: where Data/fetch-data.sh leaves them.
  std::string Fetched;
  bool Full = false;
};

// Nothing where the arguments only ask for words, which are then printed.
std::optional<StudyWords> ParseWords(int argc, char* argv[])
{
  CLI::App program(
    "Measures error against run time, what shadows cost, and what comes out in extreme "
    "cases. A study "
    "that was interrupted goes on where it stopped.",
    "penumbra-study");
  program.set_version_flag("--version", "penumbra-study " PENUMBRA_VERSION);
  StudyWords words;
  program.add_option("STUDY", words.Study, "error, stability or speed")->type_name("STUDY");
  program.add_option("SCENE", words.Scenes, "Scene files [the study's own]")
    ->type_name("SCENE.json");
  program.add_option("--output", words.Output, "Folder for tables and charts [study]")
    ->type_name("FOLDER");
  program
    .add_option("--data", words.Fetched, "Folder of the fetched volumes, for speed [Data/fetched]")
    ->type_name("FOLDER");
  program.add_flag("--full", words.Full, "The whole grid, however long it takes");
  if (!ParseArguments(program, argc, argv))
  {
    return std::nullopt;
  }
  return words;
}

void CheckScene(const std::string& name)
{
  std::error_code ignored;
  if (!fs::is_regular_file(fs::u8path(name), ignored))
  {
    throw InputError("there is no scene file " + name);
  }
  const SceneDescription scene = LoadScene(fs::u8path(name), {});
  if (!fs::exists(scene.Volume.File, ignored))
  {
    throw InputError(name + ": there is no volume " + scene.Volume.File.u8string());
  }
}

void CheckWords(const StudyWords& words)
{
  if (words.Study != "error" && words.Study != "stability" && words.Study != "speed")
  {
    throw InputError("STUDY is \"" + words.Study + "\"; accepted: error, stability, speed");
  }
  if (words.Study == "stability" && !words.Scenes.empty())
  {
    throw InputError("the study of stability takes no scenes; it has its own");
  }
  for (const std::string& scene : words.Scenes)
  {
    CheckScene(scene);
  }
  std::error_code ignored;
  if (!words.Fetched.empty() && !fs::is_directory(fs::u8path(words.Fetched), ignored))
  {
    throw InputError("--data is " + words.Fetched + ", which is no folder");
  }
}

fs::path FetchedOf(const StudyWords& words)
{
  return words.Fetched.empty() ? fs::path(PENUMBRA_DATA) / "fetched" : fs::u8path(words.Fetched);
}

std::vector<fs::path> FilesOf(const StudyWords& words)
{
  std::vector<fs::path> files;
  for (const std::string& scene : words.Scenes)
  {
    files.push_back(fs::absolute(fs::u8path(scene)));
  }
  return files;
}

std::string CommandOf(int argc, char* argv[])
{
  std::string command = "penumbra-study";
  for (int word = 1; word < argc; ++word)
  {
    command += std::string(" ") + argv[word];
  }
  return command;
}

fs::path MakeFolder(const std::string& name)
{
  std::error_code error;
  const fs::path folder = fs::absolute(fs::u8path(name));
  fs::create_directories(folder / "work", error);
  if (error)
  {
    throw InputError("--output is " + name + ", which cannot be made a folder: " + error.message());
  }
  return folder;
}

// Bounds that are missed are an error, once everything is written.
void StudyError(const StudyWords& words, const RenderProgram& program, const fs::path& folder,
  const std::string& command)
{
  const std::vector<fs::path> files = FilesOf(words);
  const std::vector<StudyScene> scenes =
    files.empty() ? WriteDefaultScenes(folder / "scenes", PENUMBRA_DATA) : NameScenes(files);
  ErrorStudyResult result;
  {
    ProgressLine line("studying error");
    result = RunErrorStudy(
      scenes, program, { folder, words.Full, [&line](double part) { line.Tell(part); } });
  }
  WriteText(folder / "error.csv", WriteErrorCsv(result));
  WriteText(folder / "error.json", WriteErrorJson(result, command));
  WriteText(folder / "error.md", WriteErrorMarkdown(result));
  for (const std::string& scene : ScenesOf(result))
  {
    WriteChart(ChartOfTime(result, scene), folder / (scene + "-error-over-time"));
    WriteChart(ChartOfStep(result, scene), folder / (scene + "-error-over-step"));
  }
  const ErrorSummary summary = Summarize(result);
  std::cout << summary.Line << std::endl;
  // Scenes of one's own have no bounds.
  if (words.Scenes.empty() && !summary.WithinBounds)
  {
    throw std::runtime_error("a bound is missed; " + (folder / "error.md").u8string() + " tells");
  }
}

void StudyStability(
  const RenderProgram& program, const fs::path& folder, const std::string& command)
{
  std::vector<StabilityRow> rows;
  {
    ProgressLine line("studying stability");
    rows = RunStabilityStudy(GetStabilityCases(), program, folder / "stability",
      [&line](double part) { line.Tell(part); });
  }
  WriteText(folder / "stability.csv", WriteStabilityCsv(rows));
  WriteText(folder / "stability.json", WriteStabilityJson(rows, command));
  WriteText(folder / "stability.md", WriteStabilityMarkdown(rows));
  std::cout << SummarizeStability(rows) << std::endl;
  const bool allRight = std::all_of(
    rows.begin(), rows.end(), [](const StabilityRow& row) { return row.Penumbra.IsRight; });
  if (!allRight)
  {
    throw std::runtime_error(
      "not all are right; " + (folder / "stability.md").u8string() + " tells");
  }
}

// Bounds that are missed are an error, once everything is written.
void StudySpeed(const StudyWords& words, const SpeedMeasuring& measuring, const fs::path& folder,
  const std::string& command)
{
  const SpeedSceneList list = words.Scenes.empty()
    ? WriteSpeedScenes({ folder / "scenes", PENUMBRA_DATA, FetchedOf(words) })
    : SpeedSceneList{ NameSpeedScenes(FilesOf(words)), {} };
  SpeedStudyResult result;
  {
    ProgressLine line("studying speed");
    result = RunSpeedStudy(MakeSpeedGrid(list.Scenes, words.Full),
      { folder, measuring, [&line](double part) { line.Tell(part); } });
  }
  result.Notes.insert(result.Notes.begin(), list.Notes.begin(), list.Notes.end());
  WriteText(folder / "speed.csv", WriteSpeedCsv(result));
  WriteText(folder / "speed.json", WriteSpeedJson(result, command));
  WriteText(folder / "speed-calibration.json", WriteSpeedCalibration(result, command));
  WriteText(folder / "speed.md", WriteSpeedMarkdown(result));
  for (const SpeedChart& chart : MakeSpeedCharts(result.Rows))
  {
    WriteChart(chart.Chart, folder / chart.File);
  }
  EndSpeedStudy(folder);
  const SpeedSummary summary = SummarizeSpeed(result.Rows);
  std::cout << summary.Line << std::endl;
  if (!summary.WithinBounds)
  {
    throw std::runtime_error("a bound is missed; " + (folder / "speed.md").u8string() + " tells");
  }
}
}

//------------------------------------------------------------------------------
void RunStudyCommand(int argc, char* argv[])
{
  const auto words = ParseWords(argc, argv);
  if (!words)
  {
    return;
  }
  CheckWords(*words);
  const fs::path folder = MakeFolder(words->Output);
  const fs::path programs = FolderOfProgram(argv[0]);
  const RenderProgram program(programs / PENUMBRA_RENDER_NAME, folder / "work");
  if (words->Study == "error")
  {
    StudyError(*words, program, folder, CommandOf(argc, argv));
  }
  else if (words->Study == "speed")
  {
    StudySpeed(*words, { programs / PENUMBRA_DICOM_PARSER, &program, words->Full }, folder,
      CommandOf(argc, argv));
  }
  else
  {
    StudyStability(program, folder, CommandOf(argc, argv));
  }
}

}
