#include "BrightCorner.h"
#include "Catch.h"
#include "RunProgram.h"

#include <filesystem>

using namespace penumbra;

TEST_CASE("Bad input and usage end with status 2, one line, and nothing written")
{
  const BrightCorner folder;
  const auto before = folder.Names();
  struct Use
  {
    std::vector<std::string> arguments;
    std::string said;
  };
  const std::string& scene = folder.Scene;
  const std::vector<Use> uses = {
    { {}, "no scene" },
    { { scene, "--bogus" }, "--bogus" },
    { { scene, "second.json" }, "second.json" },
    { { scene, "--output", folder.PathOf("a.png"), "--output", folder.PathOf("b.png") },
      "--output" },
    { { scene, "--output", folder.PathOf("a.jpg") }, ".png or .mha" },
    { { scene, "--output", folder.PathOf("none/a.png") }, "folder" },
    { { scene, "--report", folder.PathOf("none/r.json") }, "--report" },
    { { scene, "--output", folder.PathOf("a.png"), "--report", folder.PathOf("a.png") },
      "already" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "lights.0.shadow=sofft" },
      "lights.0.shadow" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "volume.dimensions=[8,8,9]" },
      "volume.file" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "volume.mask=scene.json" },
      "volume.mask" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "volume.file=none.mhd" }, "none.mhd" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "shadows.technique=maps" },
      "shadows.technique" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "nonsense" }, "nonsense" },
    { { scene, "--frames", "-1" }, "--frames" },
    { { scene, "--frames", "two" }, "--frames" },
    { { scene, "--frames", "1", "--change", "colour" }, "--change" },
    { { scene, "--set", "lights=[]", "--frames", "1", "--change", "light" }, "--change" },
    { { scene, "--preset", "no-such-look" }, "ct-bone" },
    { { scene, "--preset", "" }, "--preset" },
    { { scene, "--output", folder.PathOf("a.png"), "--set", "material.preset=velvet" },
      "porcelain" },
    { { folder.PathOf("none.json") }, "none.json" },
    { { folder.PathOf("corner.raw") }, "volume.dimensions" },
    { { folder.PathOf("") }, "DICOM" },
  };
  for (const Use& use : uses)
  {
    const auto result = RunPenumbraRender(use.arguments);
    INFO(use.said << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(IsOneLine(result.error));
    CHECK(result.output.empty());
    CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring(use.said));
    CHECK(folder.Names() == before);
  }
}

TEST_CASE("A volume that is read is not written over")
{
  const TemporaryFolder folder;
  const std::string volume = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\n"
                             "ElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdefgh";
  const std::string file = folder.Write("v.mha", volume);
  const auto allowed = RunPenumbraRender({ file, "--output", folder.PathOf("other.mha") });
  INFO(allowed.error);
  CHECK(allowed.exitStatus == 0);
  CHECK(RunPenumbraRender({ file, "--output", file }).exitStatus == 2);
  CHECK((ReadAll(file) == volume)); // not printed, as it is binary where this fails
}

TEST_CASE("Files that a scene is read from are not written over")
{
  const TemporaryFolder folder;
  folder.Write("v.zraw", "abcdefgh");
  const std::string volume = folder.Write("v.mhd",
    "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
    "ElementDataFile = v.zraw\n");
  const std::string scene =
    folder.Write("scene.json", R"({ "volume": { "file": "v.mhd" }, "image": { "size": [8,8] } })");
  const std::string link = folder.PathOf("link.json");
  std::filesystem::create_symlink("v.zraw", link);
  const std::string linkToScene = folder.PathOf("scene link.json");
  std::filesystem::create_symlink("scene.json", linkToScene);
  const auto before = folder.Names();
  const auto uses = std::vector<std::vector<std::string>>{ { scene, "--report", scene },
    { scene, "--report", linkToScene }, { linkToScene, "--report", scene },
    { scene, "--report", folder.PathOf("v.zraw") }, { scene, "--save-scene", volume },
    { scene, "--save-scene", folder.PathOf("v.zraw") }, { volume, "--report", link },
    { volume, "--report", folder.PathOf("v.zraw") }, { volume, "--save-scene", link } };
  for (const auto& use : uses)
  {
    const auto contents = [&]
    { return ReadAll(scene) + ReadAll(volume) + ReadAll(folder.PathOf("v.zraw")); };
    const std::string read = contents();
    const auto result = RunPenumbraRender(use);
    INFO(use[0] << " " << use[1] << " " << use[2] << ": " << result.error);
    CHECK(result.exitStatus == 2);
    CHECK(IsOneLine(result.error));
    CHECK(contents() == read);
    CHECK(folder.Names() == before);
  }
}

TEST_CASE("A scene that JSON cannot hold is not rendered to be saved")
{
  const BrightCorner folder;
  std::error_code error;
  const std::filesystem::path odd = folder.PathOf("\xff.raw");
  std::filesystem::copy_file(folder.PathOf("corner.raw"), odd, error);
  if (error)
  {
    return; // this file system has no such names
  }
  const auto before = folder.Names();
  const auto result = RunPenumbraRender(
    { odd.string(), "--set", "volume.dimensions=[8,8,8]", "--set", "volume.scalarType=uint8",
      "--save-scene", folder.PathOf("saved.json"), "--output", folder.PathOf("a.png") });
  CHECK(result.exitStatus == 2);
  CHECK(IsOneLine(result.error));
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("UTF-8"));
  CHECK(folder.Names() == before);
}

TEST_CASE("A picture that cannot be rendered ends with status 1, one line, and nothing written")
{
  const TemporaryFolder folder;
  folder.Write("v.raw", std::string(80000, 'a')); // longer than any texture
  const auto before = folder.Names();
  const auto result = RunPenumbraRender({ folder.PathOf("v.raw"), "--set",
    "volume.dimensions=[20000,2,2]", "--set", "volume.scalarType=uint8", "--report",
    folder.PathOf("r.json"), "--output", folder.PathOf("p.png") });
  CHECK(result.exitStatus == 1);
  CHECK(IsOneLine(result.error));
  CHECK_THAT(result.error, Catch::Matchers::ContainsSubstring("20000"));
  CHECK(folder.Names() == before);
}
