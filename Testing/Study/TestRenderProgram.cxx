#include "Catch.h"
#include "RenderProgram.h"
#include "StudyScenes.h"
#include "TemporaryFolder.h"

#include <cstdint>
#include <filesystem>
#include <vector>

using namespace penumbra;

namespace
{
// A program of this text in penumbra-render's place.
RenderResult RunInItsPlace(const std::string& text, double timeLimit = 60.0)
{
  const TemporaryFolder folder;
  const std::string file = folder.Write("program", "#!/bin/sh\n" + text + "\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return RenderProgram(file, folder.PathOf("")).Run({ "scene.json", {}, 0, timeLimit });
}
}

TEST_CASE("However a rendering ends, it is told")
{
  CHECK(RunInItsPlace("exit 1").End == RenderEnd::Failed);
  CHECK(RunInItsPlace("exit 2").End == RenderEnd::Refused);
  CHECK(RunInItsPlace("kill -SEGV $$").End == RenderEnd::Crashed);
  CHECK(RunInItsPlace("sleep 20", 0.2).End == RenderEnd::TimedOut);
  CHECK(RenderProgram("/nowhere/program", "/tmp").Run({}).End == RenderEnd::Failed);
}

TEST_CASE("The error is the last line that is no warning")
{
  CHECK(RunInItsPlace("echo first >&2; echo the error >&2; echo warning: no >&2; exit 2").Error ==
    "the error");
}

TEST_CASE("A scene comes back as a picture and a report")
{
  const TemporaryFolder folder;
  const auto scenes = WriteDefaultScenes(folder.PathOf(""), folder.PathOf("nothing"));
  const RenderProgram program(PENUMBRA_RENDER, folder.PathOf(""));
  const RenderResult result =
    program.Run({ scenes.front().File, { "image.size=[20,10]", "sampleDistance=2" }, 2 });
  INFO(result.Error);
  REQUIRE(result.End == RenderEnd::Done);
  REQUIRE(result.Picture);
  CHECK(result.Picture->Width == 20);
  CHECK(result.Picture->Height == 10);
  CHECK(result.Report["frameCpuSeconds"].size() == 2);
  CHECK(program.Run({ scenes.front().File, { "sampleDistance=0" } }).End == RenderEnd::Refused);
}

TEST_CASE("The memory that is told is the program's, not what started it")
{
  // All of it is written to, and thereby held: more than twice what 20 x 10 pixels take.
  const std::vector<char> held(std::size_t(1) << 30, 'x');
  const TemporaryFolder folder;
  const auto scenes = WriteDefaultScenes(folder.PathOf(""), folder.PathOf("nothing"));
  const RenderResult result =
    RenderProgram(PENUMBRA_RENDER, folder.PathOf(""))
      .Run({ scenes.front().File, { "image.size=[20,10]", "sampleDistance=2" } });
  REQUIRE(result.End == RenderEnd::Done);
  CHECK(result.Report["peakMemoryBytes"].get<std::uint64_t>() < held.size());
}
