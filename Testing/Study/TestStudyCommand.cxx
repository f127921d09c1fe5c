#include "Catch.h"
#include "InputError.h"
#include "StudyCommand.h"
#include "TemporaryFolder.h"

#include <string>
#include <vector>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
std::string ErrorOf(std::vector<std::string> words)
{
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  try
  {
    RunStudyCommand(static_cast<int>(arguments.size()), arguments.data());
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}
}

TEST_CASE("Arguments that are no study are refused")
{
  const TemporaryFolder folder;
  CHECK_THAT(ErrorOf({ "penumbra-study", "fast" }),
    ContainsSubstring("STUDY is \"fast\"; accepted: error, stability, speed"));
  CHECK_THAT(ErrorOf({ "penumbra-study", "speed", "missing.json" }),
    ContainsSubstring("there is no scene file missing.json"));
  const std::string broken = folder.Write("broken.json", "{");
  CHECK_THAT(ErrorOf({ "penumbra-study", "speed", broken }), ContainsSubstring(broken));
  const std::string empty = folder.Write("empty.json", R"({ "volume": { "file": "none.vti" } })");
  CHECK_THAT(ErrorOf({ "penumbra-study", "error", empty }),
    ContainsSubstring(empty + ": there is no volume " + folder.PathOf("none.vti")));
  CHECK_THAT(ErrorOf({ "penumbra-study", "speed", "--data", folder.PathOf("missing") }),
    ContainsSubstring("--data is " + folder.PathOf("missing") + ", which is no folder"));
  CHECK_THAT(ErrorOf({ "penumbra-study", "speed", "--quick" }), ContainsSubstring("--quick"));
}
