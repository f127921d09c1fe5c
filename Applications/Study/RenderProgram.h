/**
 * @file    RenderProgram.h
 * @brief   penumbra-render as a process of its own, which may fail in any way
 */

#ifndef RenderProgram_h
#define RenderProgram_h

#include "StudyPicture.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

/// One rendering to ask for.
struct RenderRequest
{
  /// A scene file.
  std::filesystem::path Scene;
  /// Each as after --set.
  std::vector<std::string> Settings;
  /// Frames after the first, for timing.
  int Frames = 0;
  /// In seconds; a program that takes longer is ended.
  double TimeLimit = 600.0;
};

enum class RenderEnd
{
  Done,
  /// Bad input, exit status 2.
  Refused,
  /// Exit status 1 or another.
  Failed,
  /// By a signal.
  Crashed,
  TimedOut
};

struct RenderResult
{
  RenderEnd End = RenderEnd::Failed;
  /// The last line on stderr that is no warning. Empty where all went well.
  std::string Error;
  std::optional<StudyPicture> Picture;
  nlohmann::json Report;
};

class RenderProgram
{
public:
  /// `workFolder` takes files that are there for a moment.
  RenderProgram(std::filesystem::path program, std::filesystem::path workFolder);

  RenderResult Run(const RenderRequest& request) const;

  const std::filesystem::path& GetWorkFolder() const { return this->WorkFolder; }

private:
  std::filesystem::path Program;
  std::filesystem::path WorkFolder;
};

/// "done", "refused", ...
std::string NameOf(RenderEnd end);

}

#endif
