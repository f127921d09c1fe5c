#include "BrightCorner.h"
#include "Catch.h"
#include "ImageComparison.h"
#include "RunProgram.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace penumbra;

namespace
{
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

TEST_CASE("A scene may be saved over itself")
{
  const BrightCorner folder;
  const auto result = RunPenumbraRender({ folder.Scene, "--save-scene", folder.Scene });
  INFO(result.error);
  CHECK(result.exitStatus == 0);
  CHECK(nlohmann::json::parse(ReadAll(folder.Scene)).contains("sampleDistance"));
}
