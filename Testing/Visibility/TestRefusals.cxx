#include "Catch.h"
#include "ShadowedVolume.h"
#include "VTKMessages.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>

#include <functional>
#include <string>

using namespace penumbra;

namespace
{
struct Refusal
{
  std::string Message;
  std::function<void(ShadowedVolume&)> Break;
  std::function<void(ShadowedVolume&)> Mend;
};

void KeepFirstLight(ShadowedVolume& scene, const std::function<void(vtkVolumeLight*)>& change)
{
  change(vtkVolumeLight::SafeDownCast(scene.Filter->GetLights()->GetItemAsObject(0)));
}

vtkSmartPointer<vtkFloatArray> MakeArray(int tuples, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(1.0);
  return array;
}

/// Another volume in the place of the scene's.
std::function<void(ShadowedVolume&)> Replace(const std::function<void(vtkImageData*)>& change)
{
  return [=](ShadowedVolume& scene)
  {
    vtkNew<vtkImageData> other;
    other->DeepCopy(scene.Volume);
    change(other);
    scene.Filter->SetInputData(other);
  };
}

void Restore(ShadowedVolume& scene)
{
  scene.Filter->SetInputData(scene.Volume);
}

const std::vector<Refusal> Refusals = {
  { "An opacity function is needed",
    [](ShadowedVolume& scene) { scene.Filter->SetVolumeProperty(nullptr); },
    [](ShadowedVolume& scene) { scene.Filter->SetVolumeProperty(scene.Property); } },
  { "An opacity function is needed",
    [](ShadowedVolume& scene) { scene.Opacity->RemoveAllPoints(); },
    [](ShadowedVolume& scene) { scene.SetExtinction(0.1); } },
  { "Two-dimensional transfer functions",
    [](ShadowedVolume& scene)
    { scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); },
    [](ShadowedVolume& scene)
    { scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_1D); } },
  { "unit distance must be above 0",
    [](ShadowedVolume& scene) { scene.Property->SetScalarOpacityUnitDistance(0.0); },
    [](ShadowedVolume& scene) { scene.Property->SetScalarOpacityUnitDistance(1.0); } },
  { "A vtkVolumeLight is needed", [](ShadowedVolume& scene) { scene.Filter->RemoveAllLights(); },
    [](ShadowedVolume& scene) {
      scene.AddDirectional({ 0.0, 0.0, 1.0 });
    } },
  { "A vtkVolumeLight is needed",
    [](ShadowedVolume& scene)
    { KeepFirstLight(scene, [](vtkVolumeLight* light) { light->SwitchOff(); }); },
    [](ShadowedVolume& scene)
    { KeepFirstLight(scene, [](vtkVolumeLight* light) { light->SwitchOn(); }); } },
  { "A vtkVolumeLight is needed",
    [](ShadowedVolume& scene)
    { KeepFirstLight(scene, [](vtkVolumeLight* light) { light->SetShadowToNone(); }); },
    [](ShadowedVolume& scene)
    { KeepFirstLight(scene, [](vtkVolumeLight* light) { light->SetShadowToSoft(); }); } },
  { "A vtkVolumeLight is needed",
    [](ShadowedVolume& scene)
    {
      scene.Filter->RemoveAllLights();
      scene.Filter->AddLight(vtkNew<vtkLight>());
    },
    [](ShadowedVolume& scene) {
      scene.AddDirectional({ 0.0, 0.0, 1.0 });
    } },
  { "The volume has no voxels", Replace([](vtkImageData* volume) { volume->Initialize(); }),
    Restore },
  { "The volume has no scalars at its points",
    Replace([](vtkImageData* volume) { volume->GetPointData()->Initialize(); }), Restore },
  { "The volume has cell data",
    Replace(
      [](vtkImageData* volume)
      {
        volume->GetPointData()->Initialize();
        volume->GetCellData()->SetScalars(
          MakeArray(static_cast<int>(volume->GetNumberOfCells()), 1));
      }),
    Restore },
  { "The volume has 3 components",
    Replace(
      [](vtkImageData* volume)
      {
        volume->GetPointData()->SetScalars(
          MakeArray(static_cast<int>(volume->GetNumberOfPoints()), 3));
      }),
    Restore },
  { "another number of scalars",
    Replace([](vtkImageData* volume) { volume->GetPointData()->SetScalars(MakeArray(5, 1)); }),
    Restore },
  { "has no inverse", Replace([](vtkImageData* volume) { volume->SetSpacing(1.0, 0.0, 1.0); }),
    Restore },
  { "has no inverse",
    [](ShadowedVolume& scene)
    {
      vtkNew<vtkMatrix4x4> flat;
      flat->SetElement(1, 1, 0.0);
      scene.Filter->SetMatrix(flat);
    },
    [](ShadowedVolume& scene) { scene.Filter->SetMatrix(nullptr); } },
  { "The mask needs",
    [](ShadowedVolume& scene)
    {
      VolumeGrid grid;
      scene.Filter->SetMaskData(MakeUniform(grid));
    },
    [](ShadowedVolume& scene) { scene.Filter->SetMaskData(nullptr); } },
  { "The sample distance is too small",
    [](ShadowedVolume& scene) { scene.Filter->SetSampleDistance(1e-9); },
    [](ShadowedVolume& scene) { scene.Filter->SetSampleDistance(0.0); } },
};
}

TEST_CASE("What cannot be computed is refused by one error, and can be mended")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 5 };
  ShadowedVolume scene(MakeUniform(grid));
  scene.SetExtinction(0.1);
  scene.AddDirectional({ 0.0, 0.0, 1.0 });
  const std::vector<float> expected = scene.Compute();

  const Refusal refusal = GENERATE(from_range(Refusals));
  CAPTURE(refusal.Message);
  refusal.Break(scene);
  {
    VTKMessages messages;
    scene.Filter->Update();
    CHECK_THAT(messages.Text(), Catch::Matchers::ContainsSubstring(refusal.Message));
    CHECK(messages.Text().find("ERROR") == messages.Text().rfind("ERROR"));
  }
  CHECK(scene.Filter->GetOutput()->GetNumberOfPoints() == 0);

  refusal.Mend(scene);
  VTKMessages messages;
  CHECK(GetLargestDifference(scene.Compute(), expected) == 0.0);
  CHECK(messages.Text().empty());
}

TEST_CASE("A filter without an input says so")
{
  vtkNew<vtkVolumeVisibilityFilter> filter;
  VTKMessages messages;
  filter->Update();
  CHECK_THAT(messages.Text(), Catch::Matchers::ContainsSubstring("Input port 0"));
  CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}
