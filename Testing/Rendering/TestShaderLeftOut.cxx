#include "Catch.h"
#include "SceneOptions.h"
#include "ShaderSource.h"
#include "ShaderText.h"

#include <algorithm>
#include <functional>
#include <set>

using namespace penumbra;

namespace
{
struct Omission
{
  std::vector<std::string> leftOut; ///< names of entries
  std::function<void(SceneOptions&)> omit;
};

void RemoveLights(SceneOptions& options, LightKind kind)
{
  options.lights[static_cast<int>(kind)] = {};
}

void RemoveLights(SceneOptions& options, ShadowKind shadow)
{
  for (auto& lightsOfKind : options.lights)
  {
    lightsOfKind[static_cast<int>(shadow)] = 0;
  }
}

const std::vector<Omission> Omissions = {
  { { "empty-space skipping" }, [](SceneOptions& options) { options.emptySpace = false; } },
  { { "gradient opacity" }, [](SceneOptions& options) { options.gradientOpacity = false; } },
  { { "clipping planes" }, [](SceneOptions& options) { options.clippingPlanes = 0; } },
  { { "cropping" }, [](SceneOptions& options) { options.cropping = CroppingKind::None; } },
  { { "mask" }, [](SceneOptions& options) { options.mask = false; } },
  { { "diffuse term" }, [](SceneOptions& options) { options.diffuse = false; } },
  { { "specular term" }, [](SceneOptions& options) { options.specular = false; } },
  { { "two-sided lighting" }, [](SceneOptions& options) { options.twoSided = false; } },
  { { "attenuation" }, [](SceneOptions& options) { options.attenuation = false; } },
  { { "directional lights" },
    [](SceneOptions& options) { RemoveLights(options, LightKind::Directional); } },
  { { "point lights" }, [](SceneOptions& options) { RemoveLights(options, LightKind::Point); } },
  { { "spot lights" }, [](SceneOptions& options) { RemoveLights(options, LightKind::Spot); } },
  { { "soft shadows" }, [](SceneOptions& options) { RemoveLights(options, ShadowKind::Soft); } },
  { { "hard shadows" }, [](SceneOptions& options) { RemoveLights(options, ShadowKind::Hard); } },
  { { "soft shadows", "hard shadows", "shadow technique", "shadow rays" },
    [](SceneOptions& options)
    {
      RemoveLights(options, ShadowKind::Soft);
      RemoveLights(options, ShadowKind::Hard);
    } },
  { { "halved steps" }, [](SceneOptions& options) { options.halvedSteps = false; } },
  { { "gradient texture" }, [](SceneOptions& options) { options.gradientTexture = false; } },
  { { "noise fading" }, [](SceneOptions& options) { options.noiseFading = false; } },
  { { "halved steps", "gradient opacity", "shading", "gradient", "gradient texture",
      "reflection model", "diffuse term", "specular term", "noise fading", "two-sided lighting",
      "directional lights", "point lights", "spot lights", "attenuation", "soft shadows",
      "hard shadows", "shadow technique", "shadow rays" },
    [](SceneOptions& options)
    {
      options.optics = OpticalModel::AbsorptionEmission;
      options.gradientOpacity = false;
    } },
  { { "halved steps", "colour", "gradient opacity", "shading", "gradient", "gradient texture",
      "reflection model", "diffuse term", "specular term", "noise fading", "two-sided lighting",
      "directional lights", "point lights", "spot lights", "attenuation", "soft shadows",
      "hard shadows", "shadow technique", "shadow rays" },
    [](SceneOptions& options)
    {
      options.optics = OpticalModel::Absorption;
      options.gradientOpacity = false;
    } },
};

// All that can be left out. Each kind has a light without a shadow, each shadow is in two kinds.
SceneOptions MakeEverything()
{
  SceneOptions everything;
  everything.lights = { { { 1, 1, 0 }, { 1, 0, 1 }, { 1, 1, 1 } } };
  everything.opacity = TransferFunctionLookup::Table;
  return everything;
}

// What Phong's model never needs, nor a scene with a mask; FindWrongSymbols sees to it.
const std::set<std::string> OfOtherScenes = { "fresnel term", "preferred direction",
  "environment maps", "pre-integration" };

std::vector<std::string> GetLeftOut(const IlluminatedScene& scene)
{
  std::vector<std::string> names = scene.Mapper->GetRequirements().GetLeftOut();
  names.erase(std::remove_if(names.begin(), names.end(),
                [](const std::string& name) { return OfOtherScenes.count(name) > 0; }),
    names.end());
  return names;
}

int Count(const std::string& text, const std::string& part)
{
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

void CheckSource(const IlluminatedScene& scene)
{
  CHECK(FindWrongSymbols(
          scene.Mapper->GetRequirements(), scene.Mapper->GetFragmentShaderSource()) == "");
}
}

TEST_CASE("What a scene does not need is not in its program, and comes back when it is needed")
{
  const SceneOptions everything = MakeEverything();
  const auto scene = MakeScene();
  std::set<std::string> omitted;
  for (const Omission& omission : Omissions)
  {
    INFO(omission.leftOut.back());
    SetOptions(*scene, everything);
    scene->Render();
    CHECK(GetLeftOut(*scene).empty());
    CheckSource(*scene);

    SceneOptions options = everything;
    omission.omit(options);
    SetOptions(*scene, options);
    scene->Render();
    CHECK(GetLeftOut(*scene) == omission.leftOut);
    CheckSource(*scene);
    omitted.insert(omission.leftOut.begin(), omission.leftOut.end());
  }
  // Only the opacity and an optical model are never left out.
  omitted.insert(OfOtherScenes.begin(), OfOtherScenes.end());
  CHECK(omitted.size() + 2 == LightingRequirements().GetEntries().size());
}

TEST_CASE("Only a draw that goes on reads what was gathered")
{
  const LightingRequirements requirements = MakeEverything().Expected();
  const auto reads = [&](bool continued)
  {
    return GetCompiledText(GetFragmentShaderSource(requirements, continued))
             .find("scene_accumulated") != std::string::npos;
  };
  CHECK(reads(true));
  CHECK_FALSE(reads(false));
}

TEST_CASE("Only where empty space is leapt over does the geometry leave it out")
{
  LightingRequirements requirements = MakeEverything().Expected();
  CHECK(GetGeometryShaderSource(requirements).find("scene_tile") != std::string::npos);
  requirements.EmptySpaceSkipping = false;
  CHECK(GetGeometryShaderSource(requirements).empty());
}

TEST_CASE("Of every alternative a program has exactly one")
{
  const std::vector<std::string> always = { "vec4 accumulatedBefore()", "vec3 shadedColor(vec3",
    "vec2 keptByPlanes(vec2", "float gradientOpacityAt(vec3", "RayEnd rayEndAt(vec3",
    "float compositingWeight(vec4", "void main()" };
  const std::vector<std::string> lit = { "float litSide(float", "vec3 diffuseLight(ShadedPoint",
    "vec3 specularLight(ShadedPoint", "float diffuseReflection(Refl",
    "ReflectionCosines cosinesAt(", "ShadedPoint shadedPoint(", "vec3 gradientAt(vec3",
    "float attenuationOf(int" };
  const LightingRequirements everything = MakeEverything().Expected();
  LightingRequirements plainest = everything;
  plainest.Diffuse = plainest.Specular = plainest.TwoSidedLighting = plainest.Attenuation = false;
  LightingRequirements ambient;
  ambient.Optics = OpticalModel::SingleScattering;
  for (const LightingRequirements& requirements :
    { everything, plainest, ambient, LightingRequirements() })
  {
    const std::string text = GetCompiledText(GetFragmentShaderSource(requirements, true));
    for (const std::string& function : always)
    {
      INFO(function);
      CHECK(Count(text, function) == 1);
    }
    for (const std::string& function : lit)
    {
      INFO(function);
      CHECK(Count(text, function) == (requirements.NeedsNormal() ? 1 : 0));
    }
  }
}
