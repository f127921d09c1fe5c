#include "Catch.h"

#include "Refusal.h"
#include "SceneDefaults.h"
#include "SceneMaterial.h"
#include "SceneParser.h"
#include "SceneWriter.h"
#include "SyntheticVolumes.h"
#include "TemporaryFolder.h"

#include <nlohmann/json.hpp>

#include <vtkVolumeMaterial.h>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
SceneDescription Parse(const std::string& members, const std::string& folder = "/folder")
{
  const std::string scene = R"({ "volume": { "file": "v.mhd" }, "sampleDistance": 1,
    "shadows": { "sampleDistance": 1 },
    "transferFunction": { "opacity": [[0,0]], "color": [[0,1,1,1]], "opacityUnitDistance": 1 },
    )" +
    members + "}";
  return ParseScene(nlohmann::json::parse(scene), folder);
}

std::string MessageOf(const std::string& members)
{
  return RefusalOf([&] { Parse(members); });
}

const std::string EveryKey = R"("material": { "model": "cook-torrance", "ambient": 0.25,
  "diffuse": 0.5, "specular": 0.75, "specularPower": 33, "roughness": 0.4, "roughnessX": 0.2,
  "roughnessY": 0.6, "preferredDirection": [0,2,0], "slope": 0.7, "distribution": "gaussian",
  "gaussianConstant": 3, "indexOfRefraction": [1.25,1.5,1.75], "noiseFading": 2,
  "environmentMap": ["a.png","b.png","c.png","d.png","e.png","f.png"] })";
}

TEST_CASE("Every key of a material reaches the volume")
{
  const auto material = MakeVolumeMaterial(Parse(EveryKey), {});
  CHECK(material->GetReflectionModel() == vtkVolumeMaterial::CookTorrance);
  CHECK(material->GetAmbient() == 0.25);
  CHECK(material->GetDiffuse() == 0.5);
  CHECK(material->GetSpecular() == 0.75);
  CHECK(material->GetSpecularPower() == 33.0);
  CHECK(material->GetRoughness() == 0.4);
  CHECK(material->GetRoughnessX() == 0.2);
  CHECK(material->GetRoughnessY() == 0.6);
  CHECK(material->GetPreferredDirection()[1] == 2.0);
  CHECK(material->GetSlope() == 0.7);
  CHECK(material->GetDistribution() == vtkVolumeMaterial::Gaussian);
  CHECK(material->GetGaussianConstant() == 3.0);
  CHECK(material->GetIndexOfRefraction()[2] == 1.75);
  CHECK(material->GetNoiseFading() == 2.0);
}

TEST_CASE("A material's defaults are those of vtkVolumeMaterial")
{
  const auto parsed = MakeVolumeMaterial(Parse(R"("material": {})"), {});
  vtkNew<vtkVolumeMaterial> made;
  CHECK(parsed->GetReflectionModel() == made->GetReflectionModel());
  CHECK(parsed->GetRoughness() == made->GetRoughness());
  CHECK(parsed->GetRoughnessX() == made->GetRoughnessX());
  CHECK(parsed->GetRoughnessY() == made->GetRoughnessY());
  CHECK(parsed->GetPreferredDirection()[0] == made->GetPreferredDirection()[0]);
  CHECK(parsed->GetSlope() == made->GetSlope());
  CHECK(parsed->GetDistribution() == made->GetDistribution());
  CHECK(parsed->GetGaussianConstant() == made->GetGaussianConstant());
  CHECK(parsed->GetIndexOfRefraction()[0] == made->GetIndexOfRefraction()[0]);
  CHECK(parsed->GetNoiseFading() == made->GetNoiseFading());
}

TEST_CASE("Models are known by their names, in the order of the lighting module")
{
  const std::vector<std::string> names = { "phong", "blinn-phong", "oren-nayar", "ward",
    "ward-anisotropic", "cook-torrance", "reflection-map" };
  for (std::size_t model = 0; model < names.size(); ++model)
  {
    const auto scene =
      Parse(R"("material": { "environmentMap": "sky.png", "model": ")" + names[model] + "\" }");
    CHECK(static_cast<std::size_t>(scene.Material.Model) == model);
    const auto saved = nlohmann::json::parse(WriteScene(scene, "/folder"));
    CHECK(saved["material"]["model"] == names[model]);
    CHECK(saved["material"]["environmentMap"] == "sky.png");
  }
}

TEST_CASE("Gradients and optical models are known by their names")
{
  const std::vector<std::string> gradients = { "central", "forward", "backward", "sobel" };
  for (std::size_t gradient = 0; gradient < gradients.size(); ++gradient)
  {
    const auto scene = Parse(R"("gradientTexture": 8, "gradient": ")" + gradients[gradient] + "\"");
    CHECK(static_cast<std::size_t>(scene.Gradient) == gradient);
    CHECK(scene.GradientTexture == 8);
    const auto saved = nlohmann::json::parse(WriteScene(scene, "/folder"));
    CHECK(saved["gradient"] == gradients[gradient]);
    CHECK(saved["gradientTexture"] == 8);
  }
  CHECK_FALSE(Parse(R"("gradientTexture": "auto")").GradientTexture.has_value());
  CHECK(nlohmann::json::parse(WriteScene(
          Parse(R"("gradientTexture": "auto")"), "/folder"))["gradientTexture"] == "auto");
  for (const std::string model : { "absorption", "emission", "absorption-emission" })
  {
    const auto scene = Parse(R"("opticalModel": ")" + model + "\"");
    const auto saved = nlohmann::json::parse(WriteScene(scene, "/folder"));
    CHECK(saved["opticalModel"] == model);
    CHECK(saved["shade"] == false);
  }
}

TEST_CASE("A saved material is read again as it was")
{
  auto scene = Parse(EveryKey);
  ResolveScene(scene, MakeBall({}, 9.0, 2.0));
  const std::string saved = WriteScene(scene, "/folder");
  const auto again = ParseScene(nlohmann::json::parse(saved), "/folder");
  CHECK(WriteScene(again, "/folder") == saved);
  CHECK(again.Material.EnvironmentMap == scene.Material.EnvironmentMap);
  CHECK(again.Material.EnvironmentMap.at(5) == std::filesystem::path("/folder/f.png"));
}

TEST_CASE("Impossible materials are refused by their keys")
{
  struct Mistake
  {
    std::string members;
    std::string message;
  };
  const auto mistake = GENERATE(values<Mistake>({
    { R"("material": { "model": "gouraud" })", "material.model is \"gouraud\"" },
    { R"("material": { "model": "ward", "roughness": 0 })", "material.roughness is 0" },
    { R"("material": { "model": "oren-nayar", "roughness": -1 })", "material.roughness is -1" },
    { R"("material": { "model": "ward-anisotropic", "roughnessY": 0 })", "material.roughnessY" },
    { R"("material": { "model": "ward-anisotropic", "preferredDirection": [0,0,0] })",
      "material.preferredDirection" },
    { R"("material": { "model": "cook-torrance", "slope": 0 })", "material.slope is 0" },
    { R"("material": { "model": "cook-torrance", "indexOfRefraction": [1,0,1] })",
      "material.indexOfRefraction" },
    { R"("material": { "model": "cook-torrance", "gaussianConstant": -1 })",
      "material.gaussianConstant" },
    { R"("material": { "distribution": "flat" })", "material.distribution is \"flat\"" },
    { R"("material": { "model": "reflection-map" })", "material.environmentMap is missing" },
    { R"("material": { "environmentMap": ["a.png", "b.png"] })", "material.environmentMap is" },
    { R"("material": { "environmentMap": 3 })", "material.environmentMap is 3" },
    { R"("material": { "noiseFading": -1 })", "material.noiseFading is -1" },
    { R"("gradient": "scharr")", "gradient is \"scharr\"" },
    { R"("gradientTexture": 12)", "gradientTexture is 12; accepted: \"auto\", 0, 8 or 16" },
    { R"("opticalModel": "scattering")", "opticalModel is \"scattering\"" },
  }));
  CHECK_THAT(MessageOf(mistake.members), ContainsSubstring(mistake.message));
}

TEST_CASE("What a model does not use is ignored")
{
  CHECK(MessageOf(R"("material": { "roughness": -1, "slope": 0 })") == "");
}

TEST_CASE("Images of surroundings that cannot be are refused by name")
{
  const TemporaryFolder folder;
  folder.Write("text.png", "no picture");
  folder.Write("text.txt", "no picture");
  const auto messageOf = [&](const std::string& name)
  {
    const auto scene =
      Parse(R"("material": { "model": "reflection-map", "environmentMap": ")" + name + "\" }",
        folder.PathOf(""));
    return RefusalOf([&] { ReadEnvironmentImages(scene.Material); });
  };
  CHECK_THAT(messageOf("none.png"), ContainsSubstring("there is no file"));
  CHECK_THAT(messageOf("text.txt"), ContainsSubstring("no image that is known"));
  CHECK_THAT(messageOf("text.png"), ContainsSubstring("text.png"));
}
