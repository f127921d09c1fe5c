#include "StudyScenes.h"

#include "StudyVolumes.h"

#include <nlohmann/json.hpp>

#include <vtkImageData.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace penumbra
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// A picture of a volume of 64^3 from the front, the right and above, lit over the shoulder.
Json BaseScene(const std::string& volume)
{
  return Json::parse(R"({
    "volume": { "file": ")" +
    volume + R"(" },
    "transferFunction": { "opacity": [[40,0],[110,0.25],[255,0.6]],
      "color": [[0,0.9,0.3,0.2],[128,0.9,0.6,0.4],[255,1,1,0.9]], "opacityUnitDistance": 2 },
    "material": { "ambient": 0.2, "diffuse": 0.7, "specular": 0.3, "specularPower": 20 },
    "lights": [{ "type": "directional", "direction": [-0.6,-0.7,-0.4],
      "ambient": [0.5,0.5,0.5], "shadow": "soft", "shadowBias": 1 }],
    "camera": { "position": [104,80,170], "focalPoint": [31.5,31.5,31.5], "viewUp": [0,1,0],
      "viewAngle": 30 },
    "image": { "size": [128,128] } })");
}

struct AnalyticScene
{
  std::string Name;
  StudyField Field;
  /// Put over the base scene (RFC 7396).
  std::string Changes;
};

// z is up in the tree, the casting and the floor.
const char* const Upright = R"("camera": { "position": [105,-95,90], "focalPoint": [31.5,31.5,31.5],
  "viewUp": [0,0,1], "viewAngle": 30 })";

std::vector<AnalyticScene> AnalyticScenes()
{
  const std::string upright = Upright;
  return {
    { "two-balls", TwoBalls, "{}" },
    { "shells", Shells,
      R"({ "transferFunction": { "opacity": [[60,0],[255,0.35]], "opacityUnitDistance": 4 } })" },
    { "haze", Haze,
      R"({ "transferFunction": { "opacity": [[0,0],[255,0.3]], "opacityUnitDistance": 10 } })" },
    { "hard-floor", FloorAndBar,
      "{" + upright + R"(, "lights": [{ "type": "point", "position": [50,10,100], "shadow": "hard",
        "opacityThreshold": 0.5, "attenuation": [0.5,0.003,0.00005], "shadowBias": 1.5 }] })" },
    { "tree", Tree,
      "{" + upright +
        R"(, "transferFunction": { "opacity": [[50,0],[90,0.5],[255,0.9]],
          "color": [[50,0.3,0.6,0.2],[120,0.5,0.6,0.3],[200,0.7,0.5,0.3],[255,0.9,0.8,0.7]],
          "opacityUnitDistance": 1 }, "lights": [{ "type": "directional",
          "direction": [0.5,0.6,-0.8], "ambient": [0.5,0.5,0.5], "shadow": "soft" }] })" },
    { "casting", Casting,
      "{" + upright +
        R"(, "transferFunction": { "opacity": [[60,0],[120,0.15],[180,0.3],[230,0.9]],
          "color": [[60,0.55,0.58,0.62],[150,0.74,0.77,0.8],[200,0.8,0.62,0.4],[240,0.98,0.8,0.5]],
          "opacityUnitDistance": 1 }, "lights": [{ "type": "directional",
          "direction": [0.6,0.5,-0.8], "ambient": [0.5,0.5,0.5], "shadow": "soft" }] })" },
    { "steep", Shells,
      R"({ "transferFunction": { "opacity": [[126,0],[127,0.6],[140,0.6],[141,0]],
        "opacityUnitDistance": 1 } })" },
  };
}

std::vector<StudyScene> DataScenes(const fs::path& folder, const fs::path& data)
{
  const fs::path volume = data / "stent.mhd";
  std::error_code ignored;
  if (!fs::exists(volume, ignored))
  {
    return {};
  }
  Json scene = BaseScene(fs::absolute(volume).generic_u8string());
  scene.merge_patch(Json::parse(R"({ "volume": { "cropping": [20,110, 20,110, 100,190] },
    "transferFunction": { "opacity": [[170,0],[330,0.35],[760,0.95]],
      "color": [[170,0.55,0.2,0.14],[500,0.97,0.88,0.76]], "opacityUnitDistance": 1 },
    "camera": { "position": [150,-160,190], "focalPoint": [65,60,145], "viewUp": [0,0,1],
      "viewAngle": 28 },
    "lights": [{ "type": "directional", "direction": [0.4,0.8,-0.6], "ambient": [0.5,0.5,0.5],
      "shadow": "soft" }] })"));
  WriteText(folder / "ct.json", scene.dump(2) + "\n");
  return { { "ct", folder / "ct.json" } };
}

// However many voxels, the volume is as large as that of 64^3.
StudyGrid GridOf(int edge)
{
  const double spacing = 63.0 / (edge - 1);
  return { { edge, edge, edge }, { spacing, spacing, spacing } };
}

StudyScene Write(const AnalyticScene& analytic, const fs::path& folder, int edge)
{
  const std::string volume = analytic.Name + ".vti";
  WriteStudyVolume(MakeStudyVolume(GridOf(edge), analytic.Field), folder / volume);
  Json scene = BaseScene(volume);
  scene.merge_patch(Json::parse(analytic.Changes));
  const fs::path file = folder / (analytic.Name + ".json");
  WriteText(file, scene.dump(2) + "\n");
  return { analytic.Name, file };
}
}

//------------------------------------------------------------------------------
std::vector<StudyScene> WriteDefaultScenes(const fs::path& folder, const fs::path& data)
{
  fs::create_directories(folder);
  std::vector<StudyScene> scenes = DataScenes(folder, data);
  for (const AnalyticScene& analytic : AnalyticScenes())
  {
    scenes.push_back(Write(analytic, folder, 64));
  }
  return scenes;
}

//------------------------------------------------------------------------------
StudyScene WriteAnalyticScene(const std::string& name, int edge, const fs::path& folder)
{
  fs::create_directories(folder);
  const std::vector<AnalyticScene> scenes = AnalyticScenes();
  const auto found = std::find_if(
    scenes.begin(), scenes.end(), [&](const AnalyticScene& scene) { return scene.Name == name; });
  if (found == scenes.end())
  {
    throw std::invalid_argument("there is no analytic scene " + name);
  }
  return Write(*found, folder, edge);
}

//------------------------------------------------------------------------------
std::vector<StudyScene> NameScenes(const std::vector<fs::path>& files)
{
  std::vector<StudyScene> scenes;
  for (const fs::path& file : files)
  {
    std::string name = file.stem().u8string();
    const auto taken = std::count_if(scenes.begin(), scenes.end(),
      [&](const StudyScene& scene) { return scene.File.stem() == file.stem(); });
    name += taken > 0 ? "-" + std::to_string(taken + 1) : "";
    scenes.push_back({ name, file });
  }
  return scenes;
}

//------------------------------------------------------------------------------
void WriteText(const fs::path& file, const std::string& text)
{
  fs::path unfinished = file;
  unfinished += ".unfinished";
  {
    std::ofstream stream(unfinished, std::ios::binary);
    stream << text;
    if (!stream.flush())
    {
      throw std::runtime_error(file.u8string() + " cannot be written");
    }
  }
  fs::rename(unfinished, file);
}

}
