#include "Catch.h"

#include "Refusal.h"
#include "SceneFile.h"
#include "SceneParser.h"

#include <nlohmann/json.hpp>

#include <vtkType.h>

using namespace penumbra;

namespace
{
SceneDescription Parse(const std::string& members)
{
  return ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd" })" + members + "}"), "/folder");
}

std::string MessageOf(const std::string& members)
{
  return RefusalOf([&] { Parse(members); });
}

std::string RawMessageOf(const std::string& members)
{
  return RefusalOf([&]
    { ParseScene(ParseJson(R"({ "volume": { "file": "v.raw", )" + members + "} }"), "/folder"); });
}
}

TEST_CASE("A scene of a file alone has the documented defaults")
{
  const SceneDescription scene = Parse("");
  CHECK(scene.Volume.File == std::filesystem::path("/folder/v.mhd"));
  CHECK(scene.Volume.Transform[5] == 1.0);
  CHECK_FALSE(scene.Volume.Cropping);
  CHECK_FALSE(scene.TransferFunction.Opacity);
  CHECK(scene.Optics == OpticalModel::SingleScattering);
  CHECK(scene.Material.Ambient == 0.1);
  CHECK(scene.Material.Diffuse == 0.7);
  CHECK(scene.Material.Specular == 0.2);
  CHECK(scene.Material.SpecularPower == 10.0);
  REQUIRE(scene.Lights.size() == 1);
  CHECK(scene.Lights[0].Type == LightType::Headlight);
  CHECK(scene.TwoSidedLighting);
  CHECK_FALSE(scene.Shadows.SampleDistance);
  CHECK(scene.ClippingPlanes.empty());
  CHECK(scene.Camera.ViewAngle == 30.0);
  CHECK_FALSE(scene.Camera.ParallelScale);
  CHECK(scene.Image.Size == std::array<int, 2>{ 512, 512 });
  CHECK(scene.Image.Background == Vector3{ 0.0, 0.0, 0.0 });
  CHECK_FALSE(scene.SampleDistance);
  CHECK(scene.Renderer == RendererChoice::Penumbra);
}

TEST_CASE("An empty light has the documented defaults")
{
  const LightDescription light = Parse(R"(, "lights": [{}])").Lights.at(0);
  CHECK(light.Type == LightType::Directional);
  CHECK(light.On);
  CHECK(light.Frame == LightFrame::Scene);
  CHECK(light.Direction == Vector3{ 0.0, 0.0, -1.0 });
  CHECK(light.Ambient == Vector3{ 1.0, 1.0, 1.0 });
  CHECK(light.Intensity == 1.0);
  CHECK(light.Attenuation == Vector3{ 1.0, 0.0, 0.0 });
  CHECK(light.ConeAngle == 30.0);
  CHECK(light.Exponent == 1.0);
  CHECK(light.Shadow == ShadowKind::None);
  CHECK(light.OpacityThreshold == 0.95);
  CHECK_FALSE(light.ShadowBias);
}

TEST_CASE("No lights is not the same as no key \"lights\"")
{
  CHECK(Parse(R"(, "lights": [])").Lights.empty());
}

TEST_CASE("shade and opticalModel say the same")
{
  const auto opticsOf = [](const std::string& members) { return Parse(members).Optics; };
  CHECK(opticsOf(R"(, "shade": false)") == OpticalModel::AbsorptionEmission);
  CHECK(opticsOf(R"(, "shade": true)") == OpticalModel::SingleScattering);
  CHECK(opticsOf(R"(, "opticalModel": "absorption-emission")") == OpticalModel::AbsorptionEmission);
  CHECK(opticsOf(R"(, "opticalModel": "single-scattering")") == OpticalModel::SingleScattering);
  CHECK(opticsOf(R"(, "opticalModel": "absorption")") == OpticalModel::Absorption);
  CHECK(opticsOf(R"(, "shade": false, "opticalModel": "emission")") == OpticalModel::Emission);
  for (const char* model : { "absorption-emission", "absorption", "emission" })
  {
    CHECK_THAT(MessageOf(R"(, "shade": true, "opticalModel": ")" + std::string(model) + "\""),
      Catch::Matchers::ContainsSubstring("shade"));
  }
  CHECK_THAT(MessageOf(R"(, "shade": false, "opticalModel": "single-scattering")"),
    Catch::Matchers::ContainsSubstring("shade"));
}

TEST_CASE("Points of a transfer function may come in any order, and steps keep theirs")
{
  const auto opacity =
    *Parse(R"(, "transferFunction": { "opacity": [[9,1],[5,0.25],[5,0.75],[1,0]] })")
       .TransferFunction.Opacity;
  const FunctionPoints<1> sorted = { { 1.0, 0.0 }, { 5.0, 0.25 }, { 5.0, 0.75 }, { 9.0, 1.0 } };
  CHECK(opacity == sorted);
}

TEST_CASE("A .raw file's geometry is read")
{
  const VolumeDescription volume = ParseScene(ParseJson(R"({ "volume": { "file": "../V.RAW",
    "dimensions": [2, 3, 4], "scalarType": "int16", "spacing": [1, 2, 3], "byteOrder": "big",
    "direction": [-1,0,0, 0,1,0, 0,0,1], "headerBytes": 62 } })"),
    "/a/b")
                                     .Volume;
  CHECK(volume.File == std::filesystem::path("/a/V.RAW"));
  CHECK(*volume.Dimensions == std::array<int, 3>{ 2, 3, 4 });
  CHECK(*volume.ScalarType == VTK_SHORT);
  CHECK(volume.Spacing == Vector3{ 1.0, 2.0, 3.0 });
  CHECK(volume.Direction[0] == -1.0);
  CHECK(volume.BigEndian);
  CHECK(volume.HeaderBytes == 62);
}

TEST_CASE("What a light or format does not use is ignored")
{
  CHECK_NOTHROW(Parse(R"(, "lights": [{ "type": "point", "direction": [0,0,0] }])"));
  CHECK_NOTHROW(Parse(R"(, "lights": [{ "type": "directional", "coneAngle": 720 }])"));
  CHECK_NOTHROW(Parse(R"(, "material": { "roughness": -1 })"));
  CHECK_NOTHROW(ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd", "spacing": [0,0,0],
    "dimensions": [0,0,0], "scalarType": "?", "series": "1.2" } })"),
    ""));
  CHECK_THROWS_AS(
    ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd", "spacing": 1 } })"), ""), InputError);
}

TEST_CASE("An error names the key, the value and what is accepted")
{
  struct Mistake
  {
    std::string scene;
    std::string key;
    std::string value;
    std::string accepted;
  };
  const auto mistake = GENERATE(values<Mistake>({
    { R"(, "shaed": true)", "shaed", "true", "shade" },
    { R"(, "lights": [{}, { "shadow": "sofft" }])", "lights.1.shadow", "sofft",
      "none, soft, hard" },
    { R"(, "lights": [{ "shaddow": 1 }])", "lights.0.shaddow", "1", "shadow" },
    { R"(, "lights": {})", "lights", "{}", "array" },
    { R"(, "lights": [7])", "lights.0", "7", "object" },
    { R"(, "lights": [{ "direction": [0,0,0] }])", "lights.0.direction", "[0,0,0]", "zero" },
    { R"(, "lights": [{ "diffuse": [1,-1,1] }])", "lights.0.diffuse", "-1", "at least 0" },
    { R"(, "lights": [{ "type": "spot", "coneAngle": 181 }])", "lights.0.coneAngle", "181", "180" },
    { R"(, "lights": [{ "opacityThreshold": 1.5 }])", "lights.0.opacityThreshold", "1.5",
      "0 to 1" },
    { R"(, "lights": [{ "shadowBias": -1 }])", "lights.0.shadowBias", "-1", "at least 0" },
    { R"(, "lights": [{ "on": "yes" }])", "lights.0.on", "yes", "true, false" },
    { R"(, "lights": [{ "name": 5 }])", "lights.0.name", "5", "string" },
    { R"(, "material": { "ambient": 1.01 })", "material.ambient", "1.01", "0 to 1" },
    { R"(, "material": { "specularPower": -0.5 })", "material.specularPower", "-0.5",
      "at least 0" },
    { R"(, "sampleDistance": 0)", "sampleDistance", "0", "from 1e-30" },
    { R"(, "sampleDistance": "NaN")", "sampleDistance", "NaN", "number" },
    { R"(, "sampleDistance": null)", "sampleDistance", "null", "number" },
    { R"(, "shadows": { "sampleDistance": -2 })", "shadows.sampleDistance", "-2", "from 1e-30" },
    { R"(, "transferFunction": { "opacity": [] })", "transferFunction.opacity", "[]",
      "one or more" },
    { R"(, "transferFunction": { "opacity": [[0,1.5]] })", "transferFunction.opacity", "1.5",
      "0 to 1" },
    { R"(, "transferFunction": { "color": [[0,1,1]] })", "transferFunction.color", "[[0,1,1]]",
      "red" },
    { R"(, "transferFunction": { "opacityUnitDistance": 0 })",
      "transferFunction.opacityUnitDistance", "0", "more than 0" },
    { R"(, "image": { "size": [0, 5] })", "image.size", "[0,5]", "16384" },
    { R"(, "image": { "size": [512.5, 5] })", "image.size", "512.5", "whole" },
    { R"(, "image": { "size": [100000, 100000] })", "image.size", "100000", "16384" },
    { R"(, "image": { "size": [512] })", "image.size", "[512]", "array of 2" },
    { R"(, "image": { "background": [0,0,2] })", "image.background", "2", "0 to 1" },
    { R"(, "camera": { "position": [1,2,3], "focalPoint": [1,2,3] })", "camera.position",
      "[1.0,2.0,3.0]", "different" },
    { R"(, "camera": { "viewUp": [0,0,0] })", "camera.viewUp", "[0.0,0.0,0.0]", "zero" },
    { R"(, "camera": { "position": [0,0,5], "focalPoint": [0,0,0], "viewUp": [0,0,1] })",
      "camera.viewUp", "[0.0,0.0,1.0]", "across" },
    { R"(, "camera": { "viewAngle": 180 })", "camera.viewAngle", "180", "less than 180" },
    { R"(, "camera": { "parallelScale": 0 })", "camera.parallelScale", "0", "more than 0" },
    { R"(, "clippingPlanes": [{}, { "normal": [0,0,0] }])", "clippingPlanes.1.normal", "[0,0,0]",
      "zero" },
    { R"(, "renderer": "cpu")", "renderer", "cpu", "penumbra, vtk" },
    { R"(, "skipEmptySpace": 1)", "skipEmptySpace", "1", "true, false" },
  }));
  const std::string message = MessageOf(mistake.scene);
  INFO(mistake.scene << " gives \"" << message << "\"");
  CHECK(message.rfind(mistake.key + " is ", 0) == 0);
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring(mistake.value));
  CHECK_THAT(message, Catch::Matchers::ContainsSubstring(mistake.accepted));
}

TEST_CASE("A volume's mistakes are named")
{
  struct Mistake
  {
    std::string volume;
    std::string message;
  };
  const std::string needed = R"("dimensions": [1,1,1], "scalarType": "int8", )";
  const auto mistake = GENERATE_COPY(values<Mistake>({
    { R"("scalarType": "int8")", "volume.dimensions is missing" },
    { R"("dimensions": [1,1,1])", "volume.scalarType is missing" },
    { R"("dimensions": [0,1,1], "scalarType": "int8")", "volume.dimensions is [0,1,1]" },
    { R"("dimensions": [1,1,1], "scalarType": "uint9")", "volume.scalarType is \"uint9\"" },
    { needed + R"("spacing": [1,0,1])", "volume.spacing is [1,0,1]" },
    { needed + R"("direction": [1,0,0, 1,0,0, 0,0,1])", "volume.direction is" },
    { needed + R"("byteOrder": "middle")", "volume.byteOrder is \"middle\"" },
    { needed + R"("headerBytes": -1)", "volume.headerBytes is -1" },
    { needed + R"("transform": [1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1])", "volume.transform is" },
    { needed + R"("transform": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1])", "volume.transform is" },
    { needed + R"("cropping": [1,0, 0,1, 0,1])", "volume.cropping is [1,0,0,1,0,1]" },
    { needed + R"("mask": 3)", "volume.mask is 3" },
    { needed + R"("extent": 3)", "volume.extent is 3" },
  }));
  CHECK_THAT(RawMessageOf(mistake.volume), Catch::Matchers::ContainsSubstring(mistake.message));
}

TEST_CASE("Shadow techniques are known by their names, and by no others")
{
  const auto [name, technique] = GENERATE(table<std::string, TechniqueChoice>(
    { { "auto", TechniqueChoice::Auto }, { "rays", TechniqueChoice::Rays },
      { "volume", TechniqueChoice::Volume }, { "map", TechniqueChoice::Map },
      { "deep-map", TechniqueChoice::DeepMap }, { "opacity-map", TechniqueChoice::OpacityMap } }));
  CHECK(Parse(R"(, "shadows": { "technique": ")" + name + R"(" })").Shadows.Technique == technique);
  CHECK_THAT(MessageOf(R"(, "shadows": { "technique": "maps" })"),
    Catch::Matchers::ContainsSubstring("opacity-map"));
}

TEST_CASE("A key that stands twice in one object is refused")
{
  CHECK_THROWS_WITH(ParseJson(R"({ "a": [{ "b": 1, "c": 2, "b": 3 }] })"),
    Catch::Matchers::ContainsSubstring("\"b\""));
  CHECK_NOTHROW(ParseJson(R"({ "a": [{ "b": 1 }, { "b": 1 }], "b": 2 })"));
}

TEST_CASE("What is no JSON is refused with its line")
{
  CHECK_THROWS_WITH(ParseJson("{\n \"a\": 1,,\n}"), Catch::Matchers::ContainsSubstring("line 2"));
  CHECK_THROWS_AS(ParseJson(R"({ "a": 1e999 })"), InputError);
  CHECK_THROWS_AS(ParseJson(""), InputError);
}

TEST_CASE("A scene without a volume says which key is missing")
{
  CHECK_THROWS_WITH(
    ParseScene(ParseJson("{}"), ""), Catch::Matchers::ContainsSubstring("volume.file"));
  CHECK_THROWS_WITH(ParseScene(ParseJson(R"({ "volume": {} })"), ""),
    Catch::Matchers::ContainsSubstring("volume.file"));
}

TEST_CASE("JSON of more than a hundred open levels is refused")
{
  const auto nested = [](int levels)
  {
    std::string text;
    for (int level = 0; level < levels; ++level)
    {
      text += level % 2 == 0 ? "[" : "{\"a\":";
    }
    text += "0";
    for (int level = levels; level-- > 0;)
    {
      text += level % 2 == 0 ? "]" : "}";
    }
    return text;
  };
  CHECK_NOTHROW(ParseJson(nested(100)));
  CHECK_THROWS_AS(ParseJson(nested(101)), InputError);
  CHECK_THROWS_WITH(
    ParseJson(std::string(300000, '[')), Catch::Matchers::ContainsSubstring("100 levels"));
  CHECK_THROWS_WITH(ParseJson(nested(300000)), Catch::Matchers::ContainsSubstring("100 levels"));
}
