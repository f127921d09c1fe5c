#include "Catch.h"
#include "MakeLight.h"
#include "SceneOptions.h"

#include <vtkLightCollection.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace penumbra;

namespace
{
constexpr int Groups = NumberOfLightKinds * NumberOfShadowKinds;

// One light, or two of half the intensity, of every kind and shadow state, each from another side
// and of another colour; so faint that no sample is clamped.
void AddLights(IlluminatedScene& scene, int count)
{
  scene.Renderer->RemoveAllLights();
  for (int group = Groups - 1; group >= 0; --group)
  {
    for (int i = 0; i < count; ++i)
    {
      const auto light = MakeLight(static_cast<LightKind>(group / NumberOfShadowKinds),
        static_cast<ShadowKind>(group % NumberOfShadowKinds));
      light->SetPosition(
        25.0 * std::cos(0.7 * group) + 5.5, 25.0 * std::sin(0.7 * group) + 5.5, 20.0);
      light->SetFocalPoint(5.5, 5.5, 5.5);
      light->SetDiffuseColor(1.0, 0.1 * group, 1.0 - 0.1 * group);
      light->SetAmbientColor(0.0, 0.0, 0.0);
      light->SetOpacityThreshold(0.3);
      light->SetIntensity(0.12 / count);
      light->SwitchOff();
      scene.Renderer->AddLight(light);
    }
  }
}

void SwitchGroup(IlluminatedScene& scene, int group, int count, bool on)
{
  vtkLightCollection* lights = scene.Renderer->GetLights();
  for (int i = 0; i < count; ++i)
  {
    const int index = (Groups - 1 - group) * count + i;
    vtkLight::SafeDownCast(lights->GetItemAsObject(index))->SetSwitch(on);
  }
}

std::unique_ptr<IlluminatedScene> MakePlainScene()
{
  SceneOptions options;
  options.attenuation = options.gradientOpacity = options.mask = options.gathering = false;
  options.clippingPlanes = 0;
  options.cropping = CroppingKind::None;
  options.opacity = TransferFunctionLookup::Table;
  auto scene = MakeScene();
  SetOptions(*scene, options);
  scene->Renderer->SetBackground(0.0, 0.0, 0.0);
  scene->Volume->GetProperty()->SetSpecularPower(2.0);
  return scene;
}

std::vector<int> GetColors(IlluminatedScene& scene)
{
  const auto picture = scene.Render();
  const auto* colors = static_cast<unsigned char*>(picture->GetScalarPointer());
  return std::vector<int>(colors, colors + 3 * picture->GetNumberOfPoints());
}

int GetLargestDifference(const std::vector<int>& a, const std::vector<int>& b)
{
  int largest = 0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}
}

TEST_CASE("The light of all lights is the sum of the light of each")
{
  const auto scene = MakePlainScene();
  AddLights(*scene, 1);
  std::vector<int> sum = GetColors(*scene);
  CHECK(*std::max_element(sum.begin(), sum.end()) == 0);
  for (int group = 0; group < Groups; ++group)
  {
    INFO("kind " << group / NumberOfShadowKinds << ", shadow " << group % NumberOfShadowKinds);
    SwitchGroup(*scene, group, 1, true);
    const std::vector<int> alone = GetColors(*scene);
    CHECK(*std::max_element(alone.begin(), alone.end()) > 15);
    std::transform(alone.begin(), alone.end(), sum.begin(), sum.begin(), std::plus<int>());
    SwitchGroup(*scene, group, 1, false);
  }
  for (int group = 0; group < Groups; ++group)
  {
    SwitchGroup(*scene, group, 1, true);
  }
  const std::vector<int> together = GetColors(*scene);
  CHECK(*std::max_element(together.begin(), together.end()) < 255);
  // Ten pictures, each rounded by half a grey level.
  CHECK(GetLargestDifference(together, sum) <= 5);
}

TEST_CASE("Two lights of half the intensity are one light")
{
  const auto scene = MakePlainScene();
  for (int group = 0; group < Groups; ++group)
  {
    INFO("kind " << group / NumberOfShadowKinds << ", shadow " << group % NumberOfShadowKinds);
    AddLights(*scene, 1);
    SwitchGroup(*scene, group, 1, true);
    const std::vector<int> one = GetColors(*scene);
    AddLights(*scene, 2);
    SwitchGroup(*scene, group, 2, true);
    CHECK(GetLargestDifference(GetColors(*scene), one) <= 1);
  }
}
