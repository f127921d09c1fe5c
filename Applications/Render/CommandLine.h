/**
 * @file    CommandLine.h
 * @brief   what penumbra-render was asked for
 */

#ifndef CommandLine_h
#define CommandLine_h

#include "SceneChange.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct RenderCommand
{
  /// The program penumbra-dicom-parser, which is beside this one.
  std::filesystem::path DicomParser;
  /// A scene file or a volume.
  std::filesystem::path Input;
  /// Of the form key.path=value, in the order in which they are applied.
  std::vector<std::string> Settings;
  /// Appearance by name. Empty: what the scene says, or what suits the volume.
  std::string Preset;
  std::optional<std::filesystem::path> Output;
  std::optional<std::filesystem::path> Report;
  std::optional<std::filesystem::path> SavedScene;
  /// Frames after the first.
  int NumberOfFrames = 0;
  std::optional<SceneChange> Change;
  bool Explain = false;
};

/**
 * Nothing where the arguments asked for help or the version, which has then been printed.
 * @throw InputError where they are no valid use of the program.
 */
std::optional<RenderCommand> ParseCommandLine(int argc, char* argv[]);

}

#endif
