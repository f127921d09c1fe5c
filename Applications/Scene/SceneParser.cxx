#include "SceneParser.h"

#include "InputError.h"
#include "SceneNames.h"
#include "SceneSections.h"

#include <nlohmann/json.hpp>

namespace penumbra
{
namespace
{
// The largest picture that current OpenGL drivers, Mesa's among them, can draw into.
constexpr int LargestImageSize = 16384;

void ParseOptics(JsonObject& scene, OpticalModel& optics)
{
  std::optional<bool> shade;
  scene.Read("shade", shade);
  if (shade)
  {
    optics = *shade ? OpticalModel::SingleScattering : OpticalModel::AbsorptionEmission;
  }
  scene.ReadChoice("opticalModel", optics, NamesOf(optics));
  const bool scatters = optics == OpticalModel::SingleScattering;
  if (shade && *shade != scatters)
  {
    RefuseValue("shade", *scene.Find("shade"),
      std::string(scatters ? "true" : "false") + ", as opticalModel is " +
        ValueInWords(*scene.Find("opticalModel")));
  }
}

void ParseGradient(JsonObject& scene, SceneDescription& description)
{
  scene.ReadChoice("gradient", description.Gradient, NamesOf(description.Gradient));
  const nlohmann::json* bits = scene.Find("gradientTexture");
  if (bits && *bits == "auto")
  {
    description.GradientTexture.reset();
  }
  else if (bits)
  {
    if (*bits != 0 && *bits != 8 && *bits != 16)
    {
      RefuseValue("gradientTexture", *bits, "\"auto\", 0, 8 or 16");
    }
    description.GradientTexture = bits->get<int>();
  }
}

// More of them than that is marching the ray.
constexpr std::int64_t MostNearSteps = 1024;

ShadowsDescription ParseShadows(const nlohmann::json& value)
{
  ShadowsDescription shadows;
  JsonObject object(value, "shadows");
  object.ReadChoice("technique", shadows.Technique, NamesOf(shadows.Technique));
  object.Read("sampleDistance", shadows.SampleDistance, StepLengths);
  object.Read("resolution", shadows.Resolution, MoreThanZero);
  object.Read("nearSteps", shadows.NearSteps, 0, MostNearSteps);
  object.Read("tolerance", shadows.Tolerance, ZeroOrMore);
  object.RefuseUnknownKeys();
  return shadows;
}

ClippingPlaneDescription ParseClippingPlane(const nlohmann::json& value, const std::string& path)
{
  ClippingPlaneDescription plane;
  JsonObject object(value, path);
  object.Read("origin", plane.Origin, AnyNumber);
  object.Read("normal", plane.Normal, AnyNumber);
  object.RefuseUnknownKeys();
  if (Length(plane.Normal) == 0.0)
  {
    RefuseValue(object.PathOf("normal"), *object.Find("normal"), "a vector other than zero");
  }
  return plane;
}

ImageDescription ParseImage(const nlohmann::json& value)
{
  ImageDescription image;
  JsonObject object(value, "image");
  object.Read("size", image.Size, 1, LargestImageSize);
  object.Read("background", image.Background, ZeroToOne);
  object.RefuseUnknownKeys();
  return image;
}

void ParseLights(JsonObject& scene, std::vector<LightDescription>& lights)
{
  const auto entries = scene.ReadArray("lights");
  if (!scene.Find("lights"))
  {
    return;
  }
  lights.clear();
  for (const auto& [value, path] : entries)
  {
    lights.push_back(ParseLight(*value, path));
  }
}
}

//------------------------------------------------------------------------------
SceneDescription ParseScene(const nlohmann::json& json, const std::filesystem::path& folder)
{
  SceneDescription description;
  JsonObject scene(json, "");
  const nlohmann::json* volume = scene.Find("volume");
  if (!volume)
  {
    throw InputError("volume.file is missing; it names the volume to render");
  }
  description.Volume = ParseVolume(*volume, folder);
  if (const nlohmann::json* value = scene.Find("transferFunction"))
  {
    description.TransferFunction = ParseTransferFunction(*value, folder);
  }
  ParseOptics(scene, description.Optics);
  if (const nlohmann::json* value = scene.Find("material"))
  {
    description.Material = ParseMaterial(*value, folder);
  }
  ParseGradient(scene, description);
  ParseLights(scene, description.Lights);
  scene.Read("twoSidedLighting", description.TwoSidedLighting);
  if (const nlohmann::json* value = scene.Find("shadows"))
  {
    description.Shadows = ParseShadows(*value);
  }
  for (const auto& [value, path] : scene.ReadArray("clippingPlanes"))
  {
    description.ClippingPlanes.push_back(ParseClippingPlane(*value, path));
  }
  if (const nlohmann::json* value = scene.Find("camera"))
  {
    description.Camera = ParseCamera(*value);
  }
  if (const nlohmann::json* value = scene.Find("image"))
  {
    description.Image = ParseImage(*value);
  }
  scene.Read("sampleDistance", description.SampleDistance, StepLengths);
  scene.Read("skipEmptySpace", description.SkipEmptySpace);
  scene.ReadChoice("renderer", description.Renderer, NamesOf(description.Renderer));
  scene.Read("vtkScattering", description.StockScattering, { 0.0, 2.0 });
  scene.RefuseUnknownKeys();
  return description;
}

}
