#include "Catch.h"
#include "ImageComparison.h"
#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace penumbra;

namespace
{
// 8x8x8 voxels, dense and white where x and y are large; seen from +z with y up, that is the
// picture's upper right.
struct BrightCorner : TemporaryFolder
{
  BrightCorner()
  {
    std::string voxels;
    for (int voxel = 0; voxel < 512; ++voxel)
    {
      const int x = voxel % 8;
      const int y = voxel / 8 % 8;
      voxels += x >= 5 && y >= 5 ? '\xff' : '\0';
    }
    this->Write("corner.raw", voxels);
    this->Scene = this->Write("scene.json", R"({
      "volume": { "file": "corner.raw", "dimensions": [8,8,8], "scalarType": "uint8" },
      "transferFunction": { "opacity": [[0,0],[255,0.9]], "color": [[0,1,1,1]] },
      "shade": false,
      "camera": { "position": [3.5,3.5,30], "focalPoint": [3.5,3.5,3.5], "viewUp": [0,1,0] },
      "image": { "size": [48,32], "background": [0,0,0.4] } })");
  }

  std::string Scene;
};

struct Picture
{
  int width = 0;
  int height = 0;
  std::vector<float> values;

  const float* At(int x, int y) const { return &this->values.at((y * this->width + x) * 4); }
};

Picture ReadMha(const std::string& file)
{
  const std::string bytes = ReadAll(file);
  const std::string end = "ElementDataFile = LOCAL\n";
  const auto begin = bytes.find(end) + end.size();
  const std::string header = bytes.substr(0, begin);
  CHECK_THAT(header, Catch::Matchers::ContainsSubstring("ElementType = MET_FLOAT\n"));
  CHECK_THAT(header, Catch::Matchers::ContainsSubstring("ElementNumberOfChannels = 4\n"));
  CHECK_THAT(header, Catch::Matchers::ContainsSubstring("CompressedData = False\n"));
  Picture picture;
  std::sscanf(
    header.c_str() + header.find("DimSize = "), "DimSize = %d %d", &picture.width, &picture.height);
  picture.values.resize((bytes.size() - begin) / sizeof(float));
  std::memcpy(picture.values.data(), bytes.data() + begin, bytes.size() - begin);
  REQUIRE(picture.values.size() == static_cast<std::size_t>(picture.width) * picture.height * 4);
  return picture;
}

bool IsOneLine(const std::string& text)
{
  return text.size() > 1 && text.find('\n') == text.size() - 1;
}
}

TEST_CASE("A .mha picture begins at the lower left, a .png shows the same picture")
{
  const BrightCorner folder;
  for (const char* name : { "a.mha", "a.png" })
  {
    const auto result = RunPenumbraRender({ folder.Scene, "--output", folder.PathOf(name) });
    INFO(result.error);
    REQUIRE(result.exitStatus == 0);
  }
  const Picture mha = ReadMha(folder.PathOf("a.mha"));
  REQUIRE(mha.width == 48);
  REQUIRE(mha.height == 32);
  CHECK(mha.At(28, 20)[0] > 0.9f); // right of the middle and above it
  CHECK(mha.At(28, 20)[3] > 0.9f);
  CHECK(mha.At(28, 11)[0] == 0.0f);
  CHECK(mha.At(19, 20)[0] == 0.0f);
  CHECK(mha.At(28, 11)[2] == Approx(0.4));

  const auto png = ReadPNG(folder.PathOf("a.png")); // VTK turns its rows to bottom row first
  REQUIRE(png->GetNumberOfScalarComponents() == 3);
  REQUIRE(png->GetDimensions()[0] == 48);
  int differences = 0;
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 48; ++x)
    {
      const auto* levels = static_cast<const unsigned char*>(png->GetScalarPointer(x, y, 0));
      for (int channel = 0; channel < 3; ++channel)
      {
        differences += levels[channel] / 255.0f != mha.At(x, y)[channel] ? 1 : 0;
      }
    }
  }
  CHECK(differences == 0);
}

TEST_CASE("The same scene gives the same bytes, and so does the scene saved from it")
{
  const BrightCorner folder;
  const std::vector<std::string> lit = { "--set", "shade=true", "--set", "lights.0.shadow=soft",
    "--set", "lights.1.type=point", "--set", "camera={}" };
  const auto render =
    [&](const std::string& scene, std::vector<std::string> arguments, const std::string& name)
  {
    arguments.insert(arguments.begin(), { scene, "--output", folder.PathOf(name) });
    const auto result = RunPenumbraRender(arguments);
    INFO(result.error);
    REQUIRE(result.exitStatus == 0);
    return ReadAll(folder.PathOf(name));
  };
  const std::string first = render(folder.Scene, lit, "first.png");
  CHECK(render(folder.Scene, lit, "second.png") == first);

  folder.Write("elsewhere/none", "");
  const std::string saved = folder.PathOf("elsewhere/saved.json");
  auto andSave = lit;
  andSave.insert(andSave.end(), { "--save-scene", saved });
  CHECK(render(folder.Scene, andSave, "third.png") == first);
  CHECK(render(saved, {}, "fourth.png") == first);
  CHECK(render(saved, { "--frames", "1", "--change", "camera" }, "fifth.png") == first);
}

TEST_CASE("A bare volume takes settings and has a picture of its own")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender({ folder.PathOf("corner.raw"), "--set",
    "volume.dimensions=[8,8,8]", "--set", "volume.scalarType=uint8", "--set", "image.size=[64,64]",
    "--set", "lights.0.diffuse=[1,0,0]", "--output", folder.PathOf("p.mha") });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const Picture picture = ReadMha(folder.PathOf("p.mha"));
  const float brightest = *std::max_element(picture.values.begin(), picture.values.end());
  CHECK(brightest > 0.3f);
}

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

TEST_CASE("A scene may be saved over itself")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender({ folder.Scene, "--save-scene", folder.Scene });
  INFO(result.error);
  CHECK(result.exitStatus == 0);
  CHECK(nlohmann::json::parse(ReadAll(folder.Scene)).contains("sampleDistance"));
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

TEST_CASE("Help and version go to stdout with status 0")
{
  const auto help = RunPenumbraRender({ "--help" });
  CHECK(help.exitStatus == 0);
  CHECK_THAT(help.output, Catch::Matchers::ContainsSubstring("--save-scene"));
  const auto version = RunPenumbraRender({ "--version" });
  CHECK(version.exitStatus == 0);
  CHECK_THAT(version.output, Catch::Matchers::ContainsSubstring("VTK"));
}

TEST_CASE("The report has every documented key, and explaining tells the requirements")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender({ folder.Scene, "--set", "shade=true", "--set",
    "lights.0.shadow=hard", "--frames", "3", "--report", folder.PathOf("r.json"), "--explain" });
  INFO(result.error);
  REQUIRE(result.exitStatus == 0);
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  for (const char* key : { "vtkVersion", "openglRenderer", "volume", "firstFrameSeconds",
         "frameSeconds", "frameCpuSeconds", "medianFrameSeconds", "shadowUpdateSeconds",
         "technique", "requirements", "leftOut", "warnings", "peakMemoryBytes" })
  {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["volume"]["dims"] == std::vector<int>{ 8, 8, 8 });
  CHECK(report["volume"]["scalarType"] == "uint8");
  CHECK(report["volume"]["range"] == std::vector<double>{ 0.0, 255.0 });
  auto seconds = report["frameSeconds"].get<std::vector<double>>();
  REQUIRE(seconds.size() == 3);
  std::sort(seconds.begin(), seconds.end());
  CHECK(seconds[0] > 0.0);
  CHECK(report["medianFrameSeconds"] == seconds[1]);
  CHECK(report["frameCpuSeconds"].size() == 3);
  CHECK(report["technique"] == "rays");
  CHECK(report["requirements"]["hard shadows"] == "1");
  CHECK(report["peakMemoryBytes"] > 1000000);
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("hard shadows"));
  CHECK_THAT(result.output, Catch::Matchers::ContainsSubstring("leaves out"));
}

TEST_CASE("What the stock mapper leaves out is told once, on stderr and in the report")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender(
    { folder.Scene, "--set", "renderer=vtk", "--set", "lights=[{},{},{},{},{},{},{}]", "--set",
      "shade=true", "--frames", "2", "--report", folder.PathOf("r.json") });
  CHECK(result.exitStatus == 0);
  CHECK(IsOneLine(result.error));
  CHECK(result.error.rfind("warning: ", 0) == 0);
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  CHECK(report["warnings"].size() == 1);
}

TEST_CASE("What happens to the voxels is told once, on stderr and in the report")
{
  const TemporaryFolder folder;
  std::vector<float> voxels = { 0, 1, 2, std::nanf(""), 4, 5, 6, 7 };
  folder.Write("v.raw", std::string(reinterpret_cast<const char*>(voxels.data()), 32));
  const auto result =
    RunPenumbraRender({ folder.PathOf("v.raw"), "--set", "volume.dimensions=[2,2,2]", "--set",
      "volume.scalarType=float32", "--frames", "2", "--report", folder.PathOf("r.json") });
  CHECK(result.exitStatus == 0);
  CHECK(IsOneLine(result.error));
  const auto report = nlohmann::json::parse(ReadAll(folder.PathOf("r.json")));
  REQUIRE(report["warnings"].size() == 1);
  CHECK_THAT(report["warnings"][0].get<std::string>(), Catch::Matchers::ContainsSubstring("NaN"));
  CHECK(report["volume"]["range"] == std::vector<double>{ 0.0, 7.0 });
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
