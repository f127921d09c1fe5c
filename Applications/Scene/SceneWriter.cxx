#include "SceneWriter.h"

#include "JsonObject.h"
#include "ScalarTypes.h"
#include "SceneNames.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
// Keeps the order in which keys are added.
using Json = nlohmann::ordered_json;

std::string NameFrom(
  const std::filesystem::path& folder, const std::filesystem::path& file, const std::string& key)
{
  const auto base = std::filesystem::absolute(folder).lexically_normal();
  const auto relative = file.lexically_relative(base);
  const std::string name = (relative.empty() ? file : relative).generic_u8string();
  if (!IsUtf8(name))
  {
    RefuseValue(key, name, "a name in UTF-8, as no other can be written to a scene file");
  }
  return name;
}

Json WriteVolume(const VolumeDescription& volume, const std::filesystem::path& folder)
{
  Json json = { { "file", NameFrom(folder, volume.File, "volume.file") } };
  if (volume.Dimensions && volume.ScalarType)
  {
    json["dimensions"] = *volume.Dimensions;
    json["scalarType"] = ScalarTypeName(*volume.ScalarType);
    json["spacing"] = volume.Spacing;
    json["origin"] = volume.Origin;
    json["direction"] = volume.Direction;
    json["byteOrder"] = volume.BigEndian ? "big" : "little";
    json["headerBytes"] = volume.HeaderBytes;
  }
  if (volume.Series)
  {
    json["series"] = *volume.Series;
  }
  json["transform"] = volume.Transform;
  if (volume.Cropping)
  {
    json["cropping"] = *volume.Cropping;
  }
  if (volume.Mask)
  {
    json["mask"] = NameFrom(folder, *volume.Mask, "volume.mask");
  }
  return json;
}

Json WriteTransferFunction(const TransferFunctionDescription& function)
{
  Json json = { { "opacity", *function.Opacity }, { "color", *function.Color } };
  if (function.GradientOpacity)
  {
    json["gradientOpacity"] = *function.GradientOpacity;
  }
  json["opacityUnitDistance"] = *function.OpacityUnitDistance;
  return json;
}

Json WriteMaterial(const MaterialDescription& material, const std::filesystem::path& folder)
{
  Json json = { { "model", NameOf(material.Model) }, { "ambient", material.Ambient },
    { "diffuse", material.Diffuse }, { "specular", material.Specular },
    { "specularPower", material.SpecularPower }, { "roughness", material.Roughness },
    { "roughnessX", material.RoughnessX }, { "roughnessY", material.RoughnessY },
    { "preferredDirection", material.PreferredDirection }, { "slope", material.Slope },
    { "distribution", NameOf(material.Distribution) },
    { "gaussianConstant", material.GaussianConstant },
    { "indexOfRefraction", material.IndexOfRefraction } };
  std::vector<std::string> images;
  for (const auto& image : material.EnvironmentMap)
  {
    images.push_back(NameFrom(folder, image, "material.environmentMap"));
  }
  if (images.size() == 1)
  {
    json["environmentMap"] = images.front();
  }
  else if (!images.empty())
  {
    json["environmentMap"] = images;
  }
  json["noiseFading"] = material.NoiseFading;
  return json;
}

Json WriteLight(const LightDescription& light)
{
  Json json = { { "type", NameOf(light.Type) } };
  if (!light.Name.empty())
  {
    json["name"] = light.Name;
  }
  json["on"] = light.On;
  json["frame"] = NameOf(light.Frame);
  json["position"] = light.Position;
  json["direction"] = light.Direction;
  json["ambient"] = light.Ambient;
  json["diffuse"] = light.Diffuse;
  json["specular"] = light.Specular;
  json["intensity"] = light.Intensity;
  json["attenuation"] = light.Attenuation;
  json["coneAngle"] = light.ConeAngle;
  json["exponent"] = light.Exponent;
  json["shadow"] = NameOf(light.Shadow);
  json["opacityThreshold"] = light.OpacityThreshold;
  json["shadowBias"] = *light.ShadowBias;
  return json;
}

Json WriteLights(const std::vector<LightDescription>& lights)
{
  Json json = Json::array();
  for (const LightDescription& light : lights)
  {
    json.push_back(WriteLight(light));
  }
  return json;
}

Json WriteShadows(const ShadowsDescription& shadows)
{
  return { { "technique", NameOf(shadows.Technique) },
    { "sampleDistance", *shadows.SampleDistance }, { "resolution", shadows.Resolution },
    { "nearSteps", shadows.NearSteps }, { "tolerance", shadows.Tolerance } };
}

Json WriteClippingPlanes(const std::vector<ClippingPlaneDescription>& planes)
{
  Json json = Json::array();
  for (const ClippingPlaneDescription& plane : planes)
  {
    json.push_back({ { "origin", plane.Origin }, { "normal", plane.Normal } });
  }
  return json;
}

Json WriteCamera(const CameraDescription& camera)
{
  Json json = { { "position", *camera.Position }, { "focalPoint", *camera.FocalPoint },
    { "viewUp", *camera.ViewUp }, { "viewAngle", camera.ViewAngle } };
  if (camera.ParallelScale)
  {
    json["parallelScale"] = *camera.ParallelScale;
  }
  return json;
}

// Indented for people: arrays of numbers stand on one line each.
void Print(const Json& json, const std::string& indentation, std::string& text)
{
  const bool isNested =
    json.is_object() || (json.is_array() && !json.empty() && json.front().is_structured());
  if (!isNested)
  {
    text += json.dump();
    return;
  }
  const std::string inner = indentation + "  ";
  const char* separator = "\n";
  text += json.is_object() ? "{" : "[";
  for (const auto& [key, value] : json.items())
  {
    text += separator + inner + (json.is_object() ? Json(key).dump() + ": " : "");
    Print(value, inner, text);
    separator = ",\n";
  }
  text += "\n" + indentation + (json.is_object() ? "}" : "]");
}
}

//------------------------------------------------------------------------------
std::string WriteScene(const SceneDescription& scene, const std::filesystem::path& folder)
{
  Json json;
  json["volume"] = WriteVolume(scene.Volume, folder);
  json["transferFunction"] = WriteTransferFunction(scene.TransferFunction);
  json["shade"] = scene.Optics == OpticalModel::SingleScattering;
  json["material"] = WriteMaterial(scene.Material, folder);
  json["opticalModel"] = NameOf(scene.Optics);
  json["gradient"] = NameOf(scene.Gradient);
  json["gradientTexture"] = scene.GradientTexture ? Json(*scene.GradientTexture) : Json("auto");
  json["lights"] = WriteLights(scene.Lights);
  json["twoSidedLighting"] = scene.TwoSidedLighting;
  json["shadows"] = WriteShadows(scene.Shadows);
  json["clippingPlanes"] = WriteClippingPlanes(scene.ClippingPlanes);
  json["camera"] = WriteCamera(scene.Camera);
  json["image"] = { { "size", scene.Image.Size }, { "background", scene.Image.Background } };
  json["sampleDistance"] = *scene.SampleDistance;
  json["skipEmptySpace"] = scene.SkipEmptySpace;
  json["renderer"] = NameOf(scene.Renderer);
  if (scene.StockScattering > 0.0)
  {
    json["vtkScattering"] = scene.StockScattering;
  }
  std::string text;
  Print(json, "", text);
  return text + "\n";
}

}
