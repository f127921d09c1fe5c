#include "Catch.h"
#include "CoveringSet.h"
#include "SceneOptions.h"
#include "ShaderText.h"
#include "VTKMessages.h"

#include <cstdlib>

using namespace penumbra;

namespace
{
constexpr int LightOptions = NumberOfLightKinds * NumberOfShadowKinds;

// None, one or two lights of each of the nine kinds and shadow states, then what the functions
// below read in this order.
std::vector<int> GetLitLevels()
{
  std::vector<int> levels(LightOptions, 3);
  levels.insert(levels.end(), { 3, 2, 2, 6, 4, 2, 2, 2, 3, 3, 2, 3, 2, 2, 4, 3, 2 });
  return levels;
}

void SetMatter(SceneOptions& options, const int* values)
{
  const int planes[3] = { 0, 1, 6 };
  options.gradientOpacity = values[0] != 0;
  options.clippingPlanes = planes[values[1]];
  options.cropping = static_cast<CroppingKind>(values[2]);
  options.mask = values[3] != 0;
  // A table, points, or a steep table.
  options.steep = values[4] == 2;
  options.opacity = values[4] == 1 ? TransferFunctionLookup::Points : TransferFunctionLookup::Table;
  options.gathering = values[5] != 0;
  options.emptySpace = values[6] != 0;
}

void SetGradient(SceneOptions& options, const int* values)
{
  options.gradient = static_cast<GradientEstimator>(values[0]);
  options.gradientTexture = values[1] != 0;
  options.noiseFading = values[2] != 0;
}

SceneOptions MakeLitOptions(const Combination& combination)
{
  SceneOptions options;
  for (int light = 0; light < LightOptions; ++light)
  {
    options.lights[light / NumberOfShadowKinds][light % NumberOfShadowKinds] = combination[light];
  }
  const int* values = combination.data() + LightOptions;
  options.twoSided = values[1] != 0;
  options.attenuation = values[2] != 0;
  options.reflection = static_cast<ReflectionModel>(values[3]);
  // Oren and Nayar's model has a diffuse term alone.
  options.diffuse = values[0] != 1 || options.reflection == ReflectionModel::OrenNayar;
  options.specular = values[0] != 0;
  SetGradient(options, values + 4);
  SetMatter(options, values + 7);
  options.technique = static_cast<ShadowTechnique>(values[14]);
  // None, in a row, in a loop.
  constexpr int nearSteps[] = { 0, 4, 20 };
  options.nearShadowSteps = nearSteps[values[15]];
  options.halvedSteps = values[16] != 0;
  return options;
}

// Options that would not be seen in the requirements test nothing.
bool ShowsAllOptions(const Combination& combination)
{
  const SceneOptions options = MakeLitOptions(combination);
  const LightingRequirements needs = options.Expected();
  return needs.GetNumberOfLights() > 0 && needs.Attenuation == options.attenuation &&
    needs.Technique == options.technique;
}

// No shading, or ambient light alone.
SceneOptions MakeUnlitOptions(const Combination& combination)
{
  SceneOptions options;
  options.optics = static_cast<OpticalModel>(combination[0]);
  options.lights[0][1] = options.optics == OpticalModel::SingleScattering ? 0 : 1;
  SetMatter(options, combination.data() + 1);
  return options;
}

// Light from all around; the lights give their ambient terms.
SceneOptions MakeMirroringOptions(const Combination& combination)
{
  SceneOptions options;
  options.lights[1][1] = 1;
  options.reflection = ReflectionModel::ReflectionMap;
  options.diffuse = combination[0] != 1;
  options.specular = combination[0] != 0;
  SetGradient(options, combination.data() + 1);
  SetMatter(options, combination.data() + 4);
  return options;
}

// Pixels that differ from the background (26, 26, 51).
int CountPixelsOfVolume(vtkImageData* picture)
{
  const auto* colors = static_cast<unsigned char*>(picture->GetScalarPointer());
  int count = 0;
  for (vtkIdType pixel = 0; pixel < picture->GetNumberOfPoints(); ++pixel)
  {
    const unsigned char* color = colors + 3 * pixel;
    count += std::abs(color[0] - 26) + std::abs(color[1] - 26) + std::abs(color[2] - 51) > 6;
  }
  return count;
}

void CheckProgram(const SceneOptions& options)
{
  const LightingRequirements expected = options.Expected();
  std::string description = options.gathering ? "gathering" : "";
  for (const RequirementEntry& entry : expected.GetEntries())
  {
    description += "\n" + entry.Name + ": " + entry.Value;
  }
  INFO(description);
  const VTKMessages messages;
  const auto scene = MakeScene();
  SetOptions(*scene, options);
  const auto picture = scene->Render();
  // A map of first hits says that it leaves soft shadows to a deep map.
  const bool saysSo =
    expected.Technique == ShadowTechnique::Map && expected.GetNumberOfLights(ShadowKind::Soft) > 0;
  CHECK((saysSo || messages.Text().empty()));
  CHECK(scene->Mapper->GetMessages().size() == (saysSo ? 1 : 0));
  CHECK(scene->Mapper->GetRequirements() == expected);
  CHECK(scene->Mapper->GetNumberOfShaderBuilds() == 1);
  const std::string& source = scene->Mapper->GetFragmentShaderSource();
  CHECK(FindWrongSymbols(expected, source) == "");
  const bool gathers = source.find("uniform sampler2D scene_accumulated") != std::string::npos;
  CHECK(gathers == options.gathering);
  // The ball covers a third of the picture, at least half of it is left by what hides.
  CHECK(CountPixelsOfVolume(picture) > 1024 / 10);
  CHECK(CountPixelsOfVolume(picture) < 1024);
}
}

TEST_CASE("Every pair of requirements is in a combination")
{
  const std::vector<Combination> combinations = MakeCoveringSet(GetLitLevels(), ShowsAllOptions);
  CHECK(CountMissingPairs(GetLitLevels(), combinations) == 0);
  for (const Combination& combination : combinations)
  {
    CHECK(ShowsAllOptions(combination));
  }
  // All combinations would be 40 billion.
  CHECK(combinations.size() < 60);
}

TEST_CASE("Programs of every pair of requirements compile and draw")
{
  for (const Combination& combination : MakeCoveringSet(GetLitLevels(), ShowsAllOptions))
  {
    CheckProgram(MakeLitOptions(combination));
  }
}

TEST_CASE("Programs without lights compile and draw with every pair of what hides matter")
{
  const auto all = [](const Combination&) { return true; };
  for (const Combination& combination : MakeCoveringSet({ 4, 2, 3, 3, 2, 3, 2, 2 }, all))
  {
    CheckProgram(MakeUnlitOptions(combination));
  }
}

TEST_CASE("Programs of reflection maps compile and draw with every pair of what else is needed")
{
  const auto all = [](const Combination&) { return true; };
  for (const Combination& combination : MakeCoveringSet({ 3, 4, 2, 2, 2, 3, 3, 2, 3, 2, 2 }, all))
  {
    CheckProgram(MakeMirroringOptions(combination));
  }
}
