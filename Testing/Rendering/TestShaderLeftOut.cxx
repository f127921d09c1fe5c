#include "Catch.h"
#include "SceneOptions.h"
#include "ShaderSource.h"
#include "ShaderText.h"

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
  { { "soft shadows", "hard shadows", "shadow technique" },
    [](SceneOptions& options)
    {
      RemoveLights(options, ShadowKind::Soft);
      RemoveLights(options, ShadowKind::Hard);
    } },
  { { "gradient opacity", "shading", "gradient", "reflection model", "diffuse term",
      "specular term", "two-sided lighting", "directional lights", "point lights", "spot lights",
      "attenuation", "soft shadows", "hard shadows", "shadow technique" },
    [](SceneOptions& options) { options.shade = options.gradientOpacity = false; } },
};

// All that can be left out. Each kind has a light without a shadow, each shadow is in two kinds.
SceneOptions MakeEverything()
{
  SceneOptions everything;
  everything.lights = { { { 1, 1, 0 }, { 1, 0, 1 }, { 1, 1, 1 } } };
  everything.opacity = TransferFunctionLookup::Table;
  return everything;
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
    CHECK(scene->Mapper->GetRequirements().GetLeftOut().empty());
    CheckSource(*scene);

    SceneOptions options = everything;
    omission.omit(options);
    SetOptions(*scene, options);
    scene->Render();
    CHECK(scene->Mapper->GetRequirements().GetLeftOut() == omission.leftOut);
    CheckSource(*scene);
    omitted.insert(omission.leftOut.begin(), omission.leftOut.end());
  }
  // Only the opacity is never left out.
  CHECK(omitted.size() + 1 == LightingRequirements().GetEntries().size());
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

TEST_CASE("Of every alternative a program has exactly one")
{
  const std::vector<std::string> always = { "vec4 accumulatedBefore()", "vec3 shadedColor(vec3",
    "float shownByMask(inout", "float shownByCropping(inout", "vec2 keptByPlanes(vec2",
    "float gradientOpacityAt(vec3", "float extinctionOf(float", "void main()" };
  const std::vector<std::string> lit = { "float litSide(float", "vec3 diffuseLight(int",
    "vec3 specularLight(int", "float attenuationOf(int" };
  const LightingRequirements everything = MakeEverything().Expected();
  LightingRequirements plainest = everything;
  plainest.Diffuse = plainest.Specular = plainest.TwoSidedLighting = plainest.Attenuation = false;
  LightingRequirements ambient;
  ambient.Shade = true;
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
