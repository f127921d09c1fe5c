#include "Catch.h"
#include "ShadowedVolume.h"

#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkPointData.h>

#include <sstream>
#include <string>

using namespace penumbra;

namespace
{
VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 5, 6, 7 };
  return grid;
}

/// Lights of all kinds; the second and the fourth have no array.
void AddLights(ShadowedVolume& scene)
{
  scene.Opacity->AddPoint(255.0, 0.3);
  scene.AddDirectional({ 1.0, 2.0, 3.0 });
  scene.AddDirectional({ 1.0, 0.0, 0.0 })->SetShadowToNone();
  scene.AddPoint({ 3.0, 9.0, 2.0 })->SetShadowToHard();
  vtkNew<vtkLight> plain;
  scene.Filter->AddLight(plain);
  scene.AddPoint({ -5.0, 3.0, 2.0 })->SetConeAngle(40.0);
  scene.AddDirectional({ 1.0, 0.0, 0.0 })->SetLightTypeToHeadlight();
}

const std::vector<std::string> Names = { "Visibility0Directional", "Visibility2Point",
  "Visibility4Spot", "Visibility5Headlight" };
}

TEST_CASE("Each light that casts a shadow has an array named by its index and its kind")
{
  ShadowedVolume scene(MakeShells(MakeGrid(), 3.0));
  AddLights(scene);
  scene.Filter->Update();
  vtkPointData* data = scene.Filter->GetOutput()->GetPointData();
  REQUIRE(data->GetNumberOfArrays() == static_cast<int>(Names.size()));
  for (std::size_t array = 0; array < Names.size(); ++array)
  {
    CHECK(data->GetArray(array)->GetName() == Names[array]);
    CHECK(data->GetArray(array)->GetDataType() == VTK_FLOAT);
  }
  CHECK(data->GetScalars()->GetName() == Names[0]);
}

TEST_CASE("Each array is that of its light alone")
{
  ShadowedVolume scene(MakeShells(MakeGrid(), 3.0));
  AddLights(scene);
  std::vector<std::vector<float>> together;
  for (int array = 0; array < 4; ++array)
  {
    together.push_back(scene.Compute(array));
  }
  vtkSmartPointer<vtkLightCollection> lights = scene.Filter->GetLights();
  const int indices[] = { 0, 2, 4, 5 };
  for (int array = 0; array < 4; ++array)
  {
    scene.Filter->RemoveAllLights();
    scene.Filter->AddLight(vtkLight::SafeDownCast(lights->GetItemAsObject(indices[array])));
    CHECK(GetLargestDifference(scene.Compute(), together[array]) == 0.0);
  }
}

TEST_CASE("Packed arrays are the components of one")
{
  ShadowedVolume scene(MakeShells(MakeGrid(), 3.0));
  AddLights(scene);
  std::vector<std::vector<float>> apart;
  for (int array = 0; array < 4; ++array)
  {
    apart.push_back(scene.Compute(array));
  }
  scene.Filter->PackArraysOn();
  scene.Filter->Update();
  vtkPointData* data = scene.Filter->GetOutput()->GetPointData();
  REQUIRE(data->GetNumberOfArrays() == 1);
  vtkDataArray* packed = data->GetScalars();
  CHECK(std::string(packed->GetName()) == "Visibility");
  REQUIRE(packed->GetNumberOfComponents() == 4);
  for (int light = 0; light < 4; ++light)
  {
    CHECK(packed->GetComponentName(light) == Names[light]);
    for (vtkIdType point = 0; point < packed->GetNumberOfTuples(); ++point)
    {
      REQUIRE(packed->GetComponent(point, light) == apart[light][point]);
    }
  }
}

TEST_CASE("A visibility filter prints every member")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  scene.Filter->SetCroppingRegionPlanes(1, 2, 3, 4, 5, 6);
  scene.Filter->SetOutputDimensions(7, 8, 9);
  scene.Filter->PackArraysOn();
  std::ostringstream text;
  scene.Filter->Print(text);
  for (const char* line : { "VolumeProperty: 0x", "Lights: ", "CameraDirection: 0 0 -1\n",
         "Matrix: ", "ClippingPlanes: ", "Cropping: Off\n", "CroppingRegionPlanes: 1 2 3 4 5 6\n",
         "GradientEstimator: CentralDifferences\n", "SampleDistance: 0\n", "Resolution: 1\n",
         "OutputDimensions: 7 8 9\n", "NegligibleVisibility: 0\n", "PackArrays: On\n" })
  {
    CHECK_THAT(text.str(), Catch::Matchers::ContainsSubstring(line));
  }
}
