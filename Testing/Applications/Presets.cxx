#include "AppearancePreset.h"
#include "Catch.h"
#include "InputError.h"
#include "JsonObject.h"
#include "Preset.h"
#include "SceneFile.h"
#include "TemporaryFolder.h"

#include <nlohmann/json.hpp>

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <cmath>

using namespace penumbra;
using Catch::Matchers::ContainsSubstring;

namespace
{
// 1000 voxels whose values are `value` of their number.
template <typename Value>
vtkNew<vtkImageData> Volume(const Value& value)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(10, 10, 10);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* voxels = static_cast<float*>(image->GetScalarPointer());
  for (int voxel = 0; voxel < 1000; ++voxel)
  {
    voxels[voxel] = static_cast<float>(value(voxel));
  }
  return image;
}

void SetField(vtkImageData* image, const char* name, const char* text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  image->GetFieldData()->AddArray(array);
}

std::string Choice(vtkImageData* image)
{
  return ChoosePreset(image, VolumeStatistics(image)).Name;
}

// Air, soft tissue and some bone.
double HeadInHounsfield(int voxel)
{
  return voxel < 500 ? -1000.0 : voxel < 900 ? 40.0 : 800.0;
}
}

TEST_CASE("Every preset that comes along is complete and described")
{
  const std::string described = DescribePresets();
  for (const AppearancePreset& preset : GetAppearancePresets())
  {
    INFO(preset.Name);
    const Preset parsed = FindPreset(preset.Name, {});
    CHECK(parsed.Name == preset.Name);
    CHECK_FALSE(parsed.Description.empty());
    CHECK(parsed.TransferFunction.Opacity->size() > 1);
    REQUIRE(parsed.Lights);
    CHECK((*parsed.Lights)[0]["shadow"] == "soft");
    CHECK(parsed.Material);
    CHECK_THAT(described, ContainsSubstring(preset.Name) && ContainsSubstring(parsed.Description));
  }
}

TEST_CASE("A preset may be a file, and errors in it name the file and the key")
{
  const TemporaryFolder folder;
  folder.Write("look.json", R"({ "description": "mine", "transferFunction": { "scale": "threshold",
    "opacity": [[0,0],[1,1]], "color": [[0,1,0,0]] }, "lights": [] })");
  const Preset preset = FindPreset("look.json", folder.PathOf(""));
  CHECK(preset.Name == "look.json");
  CHECK(preset.Scale == PresetScale::Threshold);
  folder.Write(
    "wrong.json", R"({ "transferFunction": { "opacity": [[0,2]], "color": [[0,1,0,0]] } })");
  CHECK_THROWS_WITH(FindPreset("wrong.json", folder.PathOf("")),
    ContainsSubstring("wrong.json") && ContainsSubstring("opacity"));
  folder.Write(
    "unknown.json", R"({ "transferFunction": { "opacity": [[0,1]], "color": [[0,1,0,0]] },
    "shine": 1 })");
  CHECK_THROWS_WITH(FindPreset("unknown.json", folder.PathOf("")), ContainsSubstring("shine"));
  CHECK_THROWS_WITH(FindPreset("no-such-look", {}), ContainsSubstring("ct-bone"));
}

TEST_CASE("Named materials are known by their names alone")
{
  CHECK(FindMaterial("bone", "material.preset")["diffuse"] == 0.78);
  CHECK_THROWS_WITH(FindMaterial("velvet", "material.preset"),
    ContainsSubstring("material.preset") && ContainsSubstring("porcelain"));
}

TEST_CASE("The preset is chosen by modality, unit, range and distribution")
{
  const auto head = Volume(HeadInHounsfield);
  CHECK(Choice(head) == "ct-bone");
  const auto soft =
    Volume([](int voxel) { return voxel < 500 ? -1000.0
                             : voxel < 999    ? 40.0
                                              : 300.0; });
  CHECK(Choice(soft) == "ct-skin");
  const auto resonance = Volume([](int voxel) { return voxel; });
  SetField(resonance, "Modality", "MR");
  CHECK(Choice(resonance) == "mr-head");
  const auto tomography = Volume([](int voxel) { return voxel < 900 ? 10.0 : 1000.0; });
  SetField(tomography, "Modality", "CT");
  CHECK(Choice(tomography) == "ct-bone");
  const auto twoKinds = Volume([](int voxel) { return voxel < 700 ? voxel % 7 : 200 + voxel % 5; });
  CHECK(Choice(twoKinds) == "surface");
  // Most values are near the middle, the others spread thinner and thinner to both sides.
  const auto oneKind = Volume([](int voxel) { return std::pow((voxel - 499.5) / 500.0, 5.0); });
  CHECK(Choice(oneKind) == "cloud");
}

TEST_CASE("Percentiles and thresholds are of the volume's own values")
{
  // Half background; the rest are 101 to 600, evenly.
  const auto image = Volume([](int voxel) { return voxel < 500 ? 0.0 : voxel - 399.0; });
  const VolumeStatistics statistics(image);
  CHECK(statistics.GetLowest() == 0.0);
  CHECK(statistics.GetHighest() == 600.0);
  CHECK(statistics.GetThreshold() > 0.0);
  CHECK(statistics.GetThreshold() < 250.0);
  CHECK(statistics.GetPercentile(50, 50.0) == Approx(350.0).margin(2.0));
  CHECK(statistics.GetPercentile(0, 50.0) == Approx(101.0).margin(60.0));
  CHECK(statistics.GetPercentile(100, 50.0) == Approx(600.0).margin(1.0));
  CHECK(statistics.GetPartAbove(350.0) == Approx(0.25).margin(0.01));

  Preset preset = FindPreset("mr-head", {});
  preset.TransferFunction.Opacity = { { 0.0, 0.0 }, { 50.0, 0.5 }, { 100.0, 1.0 } };
  const auto scaled = ScaleToVolume(preset, image, statistics);
  CHECK((*scaled.Opacity)[0][0] == Approx(statistics.GetThreshold()).margin(60.0));
  CHECK((*scaled.Opacity)[2][0] == Approx(600.0).margin(1.0));
  CHECK((*scaled.Opacity)[1][1] == 0.5);
  // In 400ths of the diagonal.
  CHECK(*scaled.OpacityUnitDistance == Approx(9.0 * std::sqrt(3.0) / 400.0));
}

TEST_CASE("Hounsfield units and millimetres stay as they are")
{
  const auto image = Volume(HeadInHounsfield);
  const Preset preset = FindPreset("ct-bone", {});
  const auto scaled = ScaleToVolume(preset, image, VolumeStatistics(image));
  CHECK(*scaled.Opacity == *preset.TransferFunction.Opacity);
  CHECK(*scaled.OpacityUnitDistance == 1.0);
}

TEST_CASE("A volume of one value has a look too")
{
  const auto image = Volume([](int) { return 7.0; });
  const VolumeStatistics statistics(image);
  const auto scaled =
    ScaleToVolume(FindPreset(ChoosePreset(image, statistics).Name, {}), image, statistics);
  CHECK((*scaled.Opacity)[0][0] == 7.0);
  CHECK((*scaled.Opacity)[0][1] > 0.0);
}

TEST_CASE("A scene's own words win over the preset's")
{
  const TemporaryFolder folder;
  const std::string file = folder.Write("s.json", R"({ "volume": { "file": "v.mhd" },
    "material": { "preset": "porcelain", "specular": 0.1 },
    "transferFunction": { "preset": "ct-bone", "opacity": [[5,0.5]] } })");
  const SceneSource source(file, {}, "ct-skin");
  const SceneDescription scene = source.Describe(source.GetPreset());
  CHECK(scene.TransferFunction.FromPreset->Name == "ct-bone");
  CHECK((*scene.TransferFunction.Opacity)[0][0] == 5.0);
  CHECK(scene.Material.Specular == 0.1);
  CHECK(scene.Material.Slope == 0.12);
  CHECK(scene.Lights.size() == 3); // of the preset on the command line
  CHECK(SceneSource(file, {}).Describe("").Lights.size() == 1);
}
