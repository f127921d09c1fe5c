#include "ViewerCommand.h"

#include "InputError.h"
#include "ProgramArguments.h"
#include "ProgramFolder.h"

#include <CLI/CLI.hpp>
#include <QtGlobal>
#include <vtkVersion.h>

namespace penumbra
{
namespace
{
constexpr int SmallestWindow = 320;
constexpr int LargestWindow = 8192;
}

//------------------------------------------------------------------------------
std::optional<ViewerCommand> ParseViewerCommand(int argc, char* argv[])
{
  CLI::App program("Shows a volume illuminated and shadowed, and lets its lights, transfer "
                   "function and material be edited.",
    "penumbra-viewer");
  program.set_version_flag("--version",
    std::string("penumbra-viewer " PENUMBRA_VERSION " (VTK ") + vtkVersion::GetVTKVersion() +
      ", Qt " + qVersion() + ")");
  ViewerCommand command;
  std::string input;
  std::string screenshot;
  program.add_option("input", input, "Scene file (.json), volume file or DICOM folder");
  auto* const picture = program.add_option("--screenshot", screenshot,
    "Save the whole window, once its picture is complete, to this .png, and end");
  program.add_option("--size", command.Size, "Width and height of the window in pixels")
    ->check(CLI::Range(SmallestWindow, LargestWindow));
  if (!ParseArguments(program, argc, argv))
  {
    return std::nullopt;
  }
  if (!input.empty())
  {
    command.Input = std::filesystem::u8path(input);
  }
  if (picture->count() > 0)
  {
    command.Screenshot = std::filesystem::u8path(screenshot);
    if (command.Screenshot->extension() != ".png")
    {
      throw InputError("--screenshot is " + screenshot + "; accepted: a name that ends in .png");
    }
    if (!command.Input)
    {
      throw InputError("--screenshot needs a scene or a volume to show");
    }
  }
  command.DicomParser = FolderOfProgram(argv[0]) / PENUMBRA_DICOM_PARSER;
  return command;
}

}
