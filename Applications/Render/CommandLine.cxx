#include "CommandLine.h"

#include "InputError.h"
#include "Preset.h"
#include "ProgramArguments.h"
#include "ProgramFolder.h"

#include <CLI/CLI.hpp>
#include <vtkVersion.h>

#include <iostream>
#include <map>

namespace penumbra
{
namespace
{
constexpr int MostFrames = 1000000;

const std::map<std::string, SceneChange> ChangesByName = {
  { "light", SceneChange::Light },
  { "light-colour", SceneChange::LightColour },
  { "opacity", SceneChange::Opacity },
  { "camera", SceneChange::Camera },
};

// What the command line holds, before its words become values.
struct Words
{
  std::string Input;
  std::vector<std::string> Settings;
  std::string Output;
  std::string Report;
  std::string SavedScene;
  std::string Change;
  std::string Preset;
  bool ListPresets = false;
};

void AddOptions(CLI::App& program, Words& words, RenderCommand& command)
{
  program
    .add_option(
      "INPUT", words.Input, "Scene file (.json), or a volume: a file, or a folder of DICOM files")
    ->type_name("SCENE.json|VOLUME");
  program.add_option("--output", words.Output, "Picture to write: .png, or .mha (float32 RGBA)")
    ->type_name("FILE");
  program
    .add_option("--set", words.Settings,
      "Override or add one key of the scene; the value is JSON or a bare word")
    ->type_name("KEY.PATH=VALUE")
    ->allow_extra_args(false);
  program.add_option("--frames", command.NumberOfFrames, "Frames to render after the first [0]")
    ->type_name("N")
    ->check(CLI::Range(0, MostFrames));
  program
    .add_option("--change", words.Change,
      "What to change a little before each of these frames: light, light-colour, opacity, camera")
    ->type_name("WHAT");
  program.add_option("--report", words.Report, "JSON file for timings and what was rendered")
    ->type_name("FILE");
  program.add_flag(
    "--explain", command.Explain, "Print what the scene needs and what was left out");
  program
    .add_option("--save-scene", words.SavedScene, "Write the whole scene, defaults spelled out")
    ->type_name("FILE");
  program.add_option("--preset", words.Preset, "Appearance by name, or a preset file (.json)")
    ->type_name("NAME");
  program.add_flag("--list-presets", words.ListPresets, "Print the presets and what they show");
}

std::optional<std::filesystem::path> FileOption(
  const CLI::App& program, const std::string& option, const std::string& word)
{
  if (program.count(option) == 0)
  {
    return std::nullopt;
  }
  if (word.empty())
  {
    throw InputError(option + " is empty; it takes the name of a file");
  }
  return std::filesystem::u8path(word);
}

std::optional<SceneChange> ParseChange(const CLI::App& program, const std::string& word)
{
  if (program.count("--change") == 0)
  {
    return std::nullopt;
  }
  const auto found = ChangesByName.find(word);
  if (found == ChangesByName.end())
  {
    throw InputError(
      "--change is \"" + word + "\"; accepted: light, light-colour, opacity, camera");
  }
  return found->second;
}

RenderCommand FinishCommand(const CLI::App& program, const Words& words, RenderCommand command)
{
  if (program.count("--preset") > 0 && words.Preset.empty())
  {
    throw InputError("--preset is empty; --list-presets prints the names");
  }
  if (words.Input.empty())
  {
    throw InputError("no scene or volume was named; penumbra-render --help tells the usage");
  }
  command.Input = std::filesystem::u8path(words.Input);
  command.Settings = words.Settings;
  command.Preset = words.Preset;
  command.Output = FileOption(program, "--output", words.Output);
  command.Report = FileOption(program, "--report", words.Report);
  command.SavedScene = FileOption(program, "--save-scene", words.SavedScene);
  command.Change = ParseChange(program, words.Change);
  return command;
}
}

//------------------------------------------------------------------------------
std::optional<RenderCommand> ParseCommandLine(int argc, char* argv[])
{
  CLI::App program("Renders an illuminated, shadowed picture of a volume.", "penumbra-render");
  program.set_version_flag("--version",
    std::string("penumbra-render " PENUMBRA_VERSION " (VTK ") + vtkVersion::GetVTKVersion() + ")");
  Words words;
  RenderCommand command;
  AddOptions(program, words, command);
  command.DicomParser = FolderOfProgram(argv[0]) / PENUMBRA_DICOM_PARSER;
  if (!ParseArguments(program, argc, argv))
  {
    return std::nullopt;
  }
  if (words.ListPresets)
  {
    std::cout << DescribePresets();
    return std::nullopt;
  }
  return FinishCommand(program, words, command);
}

}
