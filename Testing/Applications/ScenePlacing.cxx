#include "Catch.h"
#include "SyntheticVolumes.h"

#include "InputError.h"
#include "SceneCamera.h"
#include "SceneDefaults.h"
#include "SceneFile.h"
#include "SceneParser.h"
#include "SceneRendering.h"
#include "VolumePlacement.h"

#include <nlohmann/json.hpp>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkVolumeLight.h>

using namespace penumbra;

namespace
{
vtkSmartPointer<vtkImageData> MakeVolume()
{
  VolumeGrid grid;
  grid.dimensions = { 16, 24, 40 };
  grid.spacing = { 1.0, 1.5, 0.5 };
  grid.origin = { 1e3, -20.0, 5.0 };
  return MakeBall(grid, 5.0, 1.0);
}

SceneDescription Resolve(const std::string& members, vtkImageData* volume)
{
  SceneDescription scene =
    ParseScene(ParseJson(R"({ "volume": { "file": "v.mhd" })" + members + "}"), "");
  ResolveScene(scene, volume);
  return scene;
}

// What a renderer does before it renders, without a window.
void PrepareFrame(const SceneRendering& rendering)
{
  rendering.GetRenderer()->InvokeEvent(vtkCommand::StartEvent);
}

void CheckNear(const double* actual, const Vector3& expected)
{
  INFO(actual[0] << " " << actual[1] << " " << actual[2]);
  for (int i = 0; i < 3; ++i)
  {
    CHECK(actual[i] == Approx(expected[i]).margin(1e-9));
  }
}

const std::string oblique =
  R"(, "camera": { "position": [10,0,0], "focalPoint": [0,0,0], "viewUp": [0,0,1] })";
}

TEST_CASE("A light of the camera's frame is placed from the eye, in lengths of the world")
{
  // The camera looks along -x with z up: right is +y, up is +z, towards the viewer +x.
  const auto volume = MakeVolume();
  const SceneDescription scene = Resolve(oblique + R"(, "lights": [
    { "type": "point", "frame": "camera", "position": [1,2,3] },
    { "type": "directional", "frame": "camera", "direction": [0,0,-4] },
    { "type": "spot", "frame": "camera", "position": [0,0,-7], "direction": [2,0,0] }])",
    volume);
  SceneRendering rendering(scene, { volume, nullptr });
  PrepareFrame(rendering);
  const auto& lights = rendering.GetLights();
  CheckNear(lights[0]->GetTransformedPosition(), { 13.0, 1.0, 2.0 });
  const Vector3 from{ lights[1]->GetPosition()[0], lights[1]->GetPosition()[1],
    lights[1]->GetPosition()[2] };
  const Vector3 to{ lights[1]->GetFocalPoint()[0], lights[1]->GetFocalPoint()[1],
    lights[1]->GetFocalPoint()[2] };
  CheckNear(Difference(to, from).data(), { -1.0, 0.0, 0.0 });
  CheckNear(lights[2]->GetPosition(), { 3.0, 0.0, 0.0 });
  CheckNear(lights[2]->GetFocalPoint(), { 3.0, 1.0, 0.0 });
}

TEST_CASE("A light of the camera's frame follows the camera, and one of the scene stays")
{
  const auto volume = MakeVolume();
  const SceneDescription scene = Resolve(oblique + R"(, "lights": [
    { "type": "point", "frame": "camera", "position": [1,2,3] },
    { "type": "point", "position": [1,2,3] }])",
    volume);
  SceneRendering rendering(scene, { volume, nullptr });
  vtkCamera* camera = rendering.GetRenderer()->GetActiveCamera();
  camera->SetPosition(0.0, -5.0, 0.0); // right +x, up +z, towards the viewer -y
  PrepareFrame(rendering);
  CheckNear(rendering.GetLights()[0]->GetPosition(), { 1.0, -8.0, 2.0 });
  CheckNear(rendering.GetLights()[1]->GetPosition(), { 1.0, 2.0, 3.0 });

  rendering.DetachFromCamera(0);
  camera->SetPosition(0.0, 0.0, 50.0);
  PrepareFrame(rendering);
  CheckNear(rendering.GetLights()[0]->GetPosition(), { 1.0, -8.0, 2.0 });
}

TEST_CASE("Lights have the kinds that they are described with")
{
  const auto volume = MakeVolume();
  const SceneDescription scene = Resolve(R"(, "lights": [{ "direction": [0,-2,0] },
    { "type": "point", "attenuation": [1,2,3] }, { "type": "spot", "coneAngle": 20, "exponent": 3 },
    { "type": "headlight", "shadow": "hard", "opacityThreshold": 0.5, "on": false }])",
    volume);
  const SceneRendering rendering(scene, { volume, nullptr });
  const auto& lights = rendering.GetLights();
  CHECK(GetLightKind(lights[0]) == LightKind::Directional);
  CHECK(GetLightKind(lights[1]) == LightKind::Point);
  CHECK(lights[1]->GetAttenuationValues()[2] == 3.0);
  CHECK(GetLightKind(lights[2]) == LightKind::Spot);
  CHECK(lights[2]->GetConeAngle() == 20.0);
  CHECK(lights[2]->GetExponent() == 3.0);
  CHECK(lights[3]->LightTypeIsHeadlight());
  CHECK(GetLightKind(lights[3]) == LightKind::Directional);
  CHECK(GetShadowKind(lights[3]) == ShadowKind::Hard);
  CHECK(lights[3]->GetOpacityThreshold() == 0.5);
  CHECK(lights[3]->GetShadowBias() == 0.5); // the smallest spacing
  CHECK_FALSE(lights[3]->GetSwitch());
}

TEST_CASE("The stock mapper gets no more lights than it can hold, and the scene says so")
{
  const auto volume = MakeVolume();
  const SceneDescription scene = Resolve(
    R"(, "renderer": "vtk", "lights": [{ "on": false }, {}, {}, {}, {}, {}, {}, {}])", volume);
  const SceneRendering rendering(scene, { volume, nullptr });
  CHECK(rendering.GetRenderer()->GetLights()->GetNumberOfItems() == 7);
  REQUIRE(rendering.GetWarnings().size() == 1);
  CHECK_THAT(rendering.GetWarnings()[0], Catch::Matchers::ContainsSubstring("6 lights"));
}

TEST_CASE("By default the whole volume is in the picture and fills it")
{
  const auto volume = MakeVolume();
  const auto members = GENERATE(values<std::string>({ "", R"(, "image": { "size": [300, 100] })",
    R"(, "image": { "size": [100, 300] })", R"(, "camera": { "viewUp": [0,1,0] })",
    R"(, "camera": { "viewUp": [-0.5,-1,0.4], "viewAngle": 60 })",
    R"(, "camera": { "focalPoint": [1005, 0, 10] })" }));
  INFO(members);
  const SceneDescription scene = Resolve(members, volume);
  const double aspect = static_cast<double>(scene.Image.Size[0]) / scene.Image.Size[1];
  SceneRendering rendering(scene, { volume, nullptr });
  PrepareFrame(rendering);
  vtkMatrix4x4* toPicture =
    rendering.GetRenderer()->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      aspect, -1.0, 1.0);
  double largest = 0.0;
  const VolumeBox box(volume, scene.Volume.Transform);
  for (const Vector3& corner : box.GetCorners())
  {
    double point[4] = { corner[0], corner[1], corner[2], 1.0 };
    toPicture->MultiplyPoint(point, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(std::abs(point[axis] / point[3]) < 1.0);
    }
    largest = std::max({ largest, std::abs(point[0] / point[3]), std::abs(point[1] / point[3]) });
  }
  CHECK(largest > 0.9);
}

TEST_CASE("The box of a volume takes direction, transform and single slices into account")
{
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(3, 5, 1);
  slice->SetSpacing(2.0, 1.0, 4.0);
  slice->SetOrigin(10.0, 0.0, 0.0);
  slice->SetDirectionMatrix(-1, 0, 0, 0, 0, 1, 0, 1, 0); // x mirrored, y and z exchanged
  const VolumeBox box(slice, { 1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1 });
  CheckNear(box.GetCorners().front().data(), { 110.0, -2.0, 0.0 });
  CheckNear(box.GetCorners().back().data(), { 106.0, 2.0, 8.0 });
  CheckNear(box.GetCenter().data(), { 108.0, 0.0, 4.0 });
}

TEST_CASE("The clipping range holds the box, and begins close to an eye within it")
{
  const auto volume = MakeVolume();
  SceneRendering rendering(Resolve("", volume), { volume, nullptr });
  vtkCamera* camera = rendering.GetRenderer()->GetActiveCamera();
  camera->SetFocalPoint(1007.5, -2.75, 9.75); // in the middle; z is from 5 to 24.5
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetPosition(1007.5, -2.75, 124.5);
  PrepareFrame(rendering);
  CHECK(camera->GetClippingRange()[0] < 100.0);
  CHECK(camera->GetClippingRange()[0] > 50.0);
  CHECK(camera->GetClippingRange()[1] > 119.5);
  camera->SetPosition(1007.5, -2.75, 14.0);
  PrepareFrame(rendering);
  CHECK(camera->GetClippingRange()[0] > 0.0);
  CHECK(camera->GetClippingRange()[0] < 0.01);
  CHECK(camera->GetClippingRange()[1] > 9.0);
}

TEST_CASE("A camera that is partly given and does not go with the volume is refused")
{
  const auto volume = MakeVolume();
  const Vector3 center = VolumeBox(volume, SceneDescription().Volume.Transform).GetCenter();
  const std::string position = nlohmann::json(center).dump();
  CHECK_THROWS_AS(Resolve(R"(, "camera": { "position": )" + position + "}", volume), InputError);
}

TEST_CASE("A scene's unit vectors are not the modules', of which zero has one")
{
  const Vector3 tiny = UnitVector({ 0.0, 3e-300, -4e-300 });
  CHECK(tiny[0] == 0.0);
  CHECK(tiny[1] == Approx(0.6));
  CHECK(tiny[2] == Approx(-0.8));
  CHECK(Normalized({ 0.0, 0.0, 0.0 }) == Vector3{ 0.0, 0.0, 0.0 });
}
