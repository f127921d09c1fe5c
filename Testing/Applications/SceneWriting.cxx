#include "Catch.h"
#include "SyntheticVolumes.h"

#include "InputError.h"
#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneWriter.h"

#include <nlohmann/json.hpp>

using namespace penumbra;

namespace
{
SceneDescription Resolved(const std::string& text, const std::string& folder)
{
  SceneDescription scene = ParseScene(ParseJson(text), folder);
  VolumeGrid grid;
  grid.spacing = { 0.7, 0.9, 1.1 };
  ResolveScene(scene, MakeBall(grid, 9.0, 2.0));
  return scene;
}

const std::string everything = R"({ "volume": { "file": "sub/v.raw", "dimensions": [32,32,32],
  "scalarType": "uint8", "spacing": [0.7,0.9,1.1], "origin": [0.1,0.2,0.3],
  "direction": [0,1,0, 1,0,0, 0,0,1], "byteOrder": "big", "headerBytes": 7,
  "transform": [2,0,0,0.1, 0,2,0,0.2, 0,0,2,0.3, 0,0,0,1], "cropping": [1,2,3,4,5,6],
  "mask": "m.raw" },
  "transferFunction": { "opacity": [[0.1,0],[0.1,0.3]], "color": [[1,0.1,0.2,0.3]],
    "gradientOpacity": [[0,0],[10,1]], "opacityUnitDistance": 0.3 },
  "shade": false, "material": { "ambient": 0.3, "diffuse": 0.4, "specular": 0.5,
    "specularPower": 6 },
  "lights": [{ "type": "spot", "name": "key", "on": false, "frame": "camera",
    "position": [1,2,3], "direction": [4,5,6], "ambient": [0.1,0.2,0.3], "diffuse": [2,3,4],
    "specular": [5,6,7], "intensity": 0.1, "attenuation": [1,2,3], "coneAngle": 40, "exponent": 2,
    "shadow": "hard", "opacityThreshold": 0.7, "shadowBias": 0.1 }, { "shadow": "soft" },
    { "type": "point" }, { "type": "headlight" }],
  "twoSidedLighting": false, "shadows": { "sampleDistance": 0.3, "resolution": 0.5, "tolerance": 2 },
  "clippingPlanes": [{ "origin": [1,2,3], "normal": [0,0,2] }],
  "camera": { "position": [1,2,3], "focalPoint": [0.1,0,0], "viewUp": [0,1,0], "viewAngle": 20,
    "parallelScale": 5 },
  "image": { "size": [20,30], "background": [0.1,0.2,0.3] }, "sampleDistance": 0.1,
  "skipEmptySpace": false, "renderer": "vtk", "vtkScattering": 0.5 })";
}

TEST_CASE("A saved scene says the same as the scene it was saved from")
{
  const auto text =
    GENERATE(values<std::string>({ everything, R"({ "volume": { "file": "v.mhd" } })" }));
  const SceneDescription scene = Resolved(text, "/a");
  const std::string saved = WriteScene(scene, "/a");
  CHECK(WriteScene(Resolved(saved, "/a"), "/a") == saved);
}

TEST_CASE("A saved scene keeps every key that was given")
{
  const auto given = ParseJson(everything).flatten();
  const auto saved = ParseJson(WriteScene(Resolved(everything, "/a"), "/a")).flatten();
  for (const auto& [key, value] : given.items())
  {
    INFO(key);
    REQUIRE(saved.contains(key));
    CHECK(saved[key] == value);
  }
}

TEST_CASE("A saved scene spells every choice out")
{
  const auto saved =
    ParseJson(WriteScene(Resolved(R"({ "volume": { "file": "v.mhd" } })", "/a"), "/a"));
  CHECK(saved["sampleDistance"] == 0.35);
  CHECK(saved["shadows"]["sampleDistance"] == 0.7);
  CHECK(saved["shadows"]["technique"] == "auto");
  CHECK(saved["lights"][0]["shadowBias"] == 0.7);
  CHECK(saved["transferFunction"]["opacityUnitDistance"] > 0.0);
  CHECK(saved["transferFunction"]["opacity"].size() > 1);
  CHECK(saved["camera"]["position"].size() == 3);
  CHECK(saved["opticalModel"] == "single-scattering");
}

TEST_CASE("A saved scene finds its files from its own folder")
{
  const SceneDescription scene = Resolved(everything, "/a/b");
  const auto saved = ParseJson(WriteScene(scene, "/a/c/d"));
  CHECK(saved["volume"]["file"] == "../../b/sub/v.raw");
  CHECK(saved["volume"]["mask"] == "../../b/m.raw");
}

TEST_CASE("A file whose name JSON cannot hold is refused by its key")
{
  const auto key = GENERATE(values<std::string>({ "volume.file", "volume.mask" }));
  SceneDescription scene = Resolved(everything, "/a");
  (key == "volume.file" ? scene.Volume.File : *scene.Volume.Mask) = "/a/\xff.raw";
  CHECK_THROWS_AS(WriteScene(scene, "/a"), InputError);
  CHECK_THROWS_WITH(WriteScene(scene, "/a"),
    Catch::Matchers::StartsWith(key + " is ") && Catch::Matchers::ContainsSubstring("UTF-8"));
}
