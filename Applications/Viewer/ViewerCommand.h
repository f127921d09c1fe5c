/**
 * @file    ViewerCommand.h
 * @brief   what penumbra-viewer's command line asks for
 */

#ifndef ViewerCommand_h
#define ViewerCommand_h

#include <array>
#include <filesystem>
#include <optional>

namespace penumbra
{

struct ViewerCommand
{
  /// A scene file or a volume. Empty: the window opens on its first page.
  std::optional<std::filesystem::path> Input;
  /// Where the picture of the whole window goes, which then ends the program.
  std::optional<std::filesystem::path> Screenshot;
  /// Of the window, in pixels.
  std::array<int, 2> Size = { 1280, 800 };
  /// The program penumbra-dicom-parser.
  std::filesystem::path DicomParser;
};

/**
 * Nothing where the command line asks for help or the version, which then were printed.
 * @throw InputError where it is not valid.
 */
std::optional<ViewerCommand> ParseViewerCommand(int argc, char* argv[]);

}

#endif
