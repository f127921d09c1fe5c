#include "Catch.h"
#include "ResolvedScene.h"
#include "SyntheticVolumes.h"

#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneRendering.h"

#include <nlohmann/json.hpp>

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkVersionMacros.h>
#include <vtkVolume.h>
#include <vtkVolumeMaterial.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace penumbra;

namespace
{
const std::string step = R"("opacity": [[0,0],[10,0.25],[10,0.75]],
  "color": [[0,0,0,0],[10,0.1,0.2,0.3],[10,0.4,0.5,0.6],[20,1,1,1]])";
}

TEST_CASE("Transfer functions are piecewise linear with steps")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const auto property = MakeVolumeMaterial(
    Resolve(R"(, "transferFunction": {)" + step + R"(, "opacityUnitDistance": 3 })", volume), {});
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  CHECK(opacity->GetValue(5.0) == Approx(0.125));
  CHECK(opacity->GetValue(10.0) == Approx(0.25));
  CHECK(opacity->GetValue(10.001) == Approx(0.75));
  CHECK(opacity->GetValue(1e6) == Approx(0.75));
  vtkColorTransferFunction* color = property->GetRGBTransferFunction();
  CHECK(color->GetRedValue(9.999) == Approx(0.1).margin(1e-3));
  CHECK(color->GetBlueValue(10.001) == Approx(0.6).margin(1e-3));
  CHECK(property->GetScalarOpacityUnitDistance() == 3.0);
  CHECK_FALSE(property->HasGradientOpacity());
}

TEST_CASE("The material, the gradient opacity and the shading reach the property")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const auto property = MakeVolumeMaterial(Resolve(R"(, "shade": false, "material": {
    "ambient": 0.3, "diffuse": 0.4, "specular": 0.5, "specularPower": 60 },
    "transferFunction": { "gradientOpacity": [[0,0],[8,1]] })",
                                             volume),
    {});
  CHECK(property->GetShade() == 0);
  CHECK(property->GetAmbient() == 0.3);
  CHECK(property->GetDiffuse() == 0.4);
  CHECK(property->GetSpecular() == 0.5);
  CHECK(property->GetSpecularPower() == 60.0);
  CHECK(property->GetInterpolationType() == VTK_LINEAR_INTERPOLATION);
  REQUIRE(property->HasGradientOpacity());
  CHECK(property->GetGradientOpacity()->GetValue(4.0) == Approx(0.5));
}

TEST_CASE("Both mappers get the steps, the cropping and the clipping planes of the scene")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const auto renderer = GENERATE(values<std::string>({ "penumbra", "vtk" }));
  SceneDescription scene = Resolve(R"(, "renderer": ")" + renderer + R"(",
    "sampleDistance": 0.25, "shadows": { "sampleDistance": 0.75 },
    "clippingPlanes": [{ "origin": [1,2,3], "normal": [0,0,-4] }, {}])",
    volume);
  scene.Volume.Cropping = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 };
  std::vector<std::string> warnings;
  const auto mapper = MakeMapper(scene, { volume, nullptr }, warnings);
  CHECK(warnings.empty());
  CHECK(mapper->GetInput() == volume);
  CHECK(mapper->GetSampleDistance() == 0.25f);
  CHECK_FALSE(mapper->GetAutoAdjustSampleDistances());
  CHECK_FALSE(mapper->GetUseJittering());
  CHECK(mapper->GetCropping());
  CHECK(mapper->GetCroppingRegionFlags() == VTK_CROP_SUBVOLUME);
  CHECK(mapper->GetCroppingRegionPlanes()[4] == 5.0);
  REQUIRE(mapper->GetClippingPlanes()->GetNumberOfItems() == 2);
  CHECK(mapper->GetClippingPlanes()->GetItem(0)->GetOrigin()[2] == 3.0);
  CHECK(mapper->GetClippingPlanes()->GetItem(0)->GetNormal()[2] == -1.0);
  auto* illuminated = vtkIlluminatedVolumeMapper::SafeDownCast(mapper);
  CHECK((illuminated != nullptr) == (renderer == "penumbra"));
  if (illuminated)
  {
    CHECK(illuminated->GetShadowSampleDistance() == 0.75);
  }
}

TEST_CASE("The stock mapper gets no more clipping planes than it can hold, and the scene says so")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const SceneDescription scene =
    Resolve(R"(, "renderer": "vtk", "clippingPlanes": [{},{},{},{},{},{},{},{},{},{}])", volume);
  std::vector<std::string> warnings;
  const auto mapper = MakeMapper(scene, { volume, nullptr }, warnings);
  CHECK(mapper->GetClippingPlanes()->GetNumberOfItems() == 8);
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Matchers::ContainsSubstring("8 clipping planes"));
}

TEST_CASE("The stock mapper scatters where this VTK can, and else the scene says so")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  const SceneDescription scene = Resolve(R"(, "renderer": "vtk", "vtkScattering": 1.5)", volume);
  std::vector<std::string> warnings;
  const auto mapper = MakeMapper(scene, { volume, nullptr }, warnings);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  CHECK(warnings.empty());
  CHECK(mapper->GetVolumetricScatteringBlending() == 1.5f);
  CHECK(mapper->GetGlobalIlluminationReach() == 1.0f);
#else
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Matchers::ContainsSubstring("VTK 9.2 or later"));
#endif
}

TEST_CASE("The transform, the background and the sides reach the renderer")
{
  const auto volume = MakeBall({}, 9.0, 2.0);
  SceneDescription scene =
    Resolve(R"(, "twoSidedLighting": false, "image": { "background": [0.1,0.2,0.3] })", volume);
  scene.Volume.Transform[3] = 7.0;
  const SceneRendering rendering(scene, { volume, nullptr });
  CHECK(rendering.GetVolume()->GetUserMatrix()->GetElement(0, 3) == 7.0);
  CHECK_FALSE(rendering.GetRenderer()->GetTwoSidedLighting());
  CHECK(rendering.GetRenderer()->GetBackground()[2] == 0.3);
  CHECK_FALSE(rendering.GetRenderer()->GetAutomaticLightCreation());
}

TEST_CASE("A mask hides where it is 0, and lies where the volume lies")
{
  const auto folder = std::filesystem::temp_directory_path();
  const auto file = folder / "penumbra-mask-of-two-voxels.raw";
  VolumeDescription description;
  description.File = file;
  description.Dimensions = { 2, 1, 1 };
  description.ScalarType = VTK_UNSIGNED_CHAR;
  description.Spacing = { 3.0, 4.0, 5.0 };
  description.Mask = file;
  std::ofstream(file, std::ios::binary) << std::string("\0\2", 2);
  std::vector<std::string> warnings;
  const SceneVoxels voxels = ReadVoxels(description, {}, warnings);
  std::filesystem::remove(file);
  vtkDataArray* shown = voxels.Mask->GetPointData()->GetScalars();
  CHECK(shown->GetDataType() == VTK_UNSIGNED_CHAR);
  CHECK(shown->GetComponent(0, 0) == 0.0);
  CHECK(shown->GetComponent(1, 0) > 0.0);
  CHECK(voxels.Mask->GetSpacing()[2] == 5.0);
  const auto mapper = MakeMapper(Resolve("", voxels.Volume), voxels, warnings);
  CHECK(mapper->GetMaskInput() == voxels.Mask);
  CHECK(mapper->GetMaskType() == vtkGPUVolumeRayCastMapper::BinaryMaskType);
}

TEST_CASE("The chosen transfer function hides the background and shows the object")
{
  // Background 5 to 45, object 160 to 200.
  const VolumeGrid grid;
  const auto volume = SampleField(grid,
    [&](const Point& p)
    {
      const double waves = 20.0 * std::sin(p[0]) * std::cos(0.7 * p[1]);
      return (p[2] > grid.Center()[2] + 6.0 ? 180.0 : 25.0) + waves;
    });
  const auto property = MakeVolumeMaterial(Resolve("", volume), {});
  CHECK(property->GetScalarOpacity()->GetValue(45.0) == 0.0);
  CHECK(property->GetScalarOpacity()->GetValue(160.0) > 0.1);
  CHECK(property->GetScalarOpacity()->GetValue(200.0) > 0.5);
}
