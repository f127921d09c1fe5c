#include "Catch.h"
#include "LitShells.h"

#include <vtkCommand.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

using namespace penumbra;

namespace
{
int CountExecutions(vtkAlgorithm* filter, const std::function<void()>& change)
{
  filter->Update();
  int executions = 0;
  const Observation observation(filter, vtkCommand::StartEvent, [&]() { ++executions; });
  change();
  filter->Update();
  filter->Update();
  return executions;
}
}

TEST_CASE("The filter executes again when something it depends on changed, and only then")
{
  LitShells scene;
  vtkVolumeVisibilityFilter* filter = scene.Filter;
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkMatrix4x4> transform;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPlane> otherPlane;
  filter->SetMatrix(matrix);
  filter->AddClippingPlane(plane);
  filter->AddClippingPlane(otherPlane);
  const auto otherLight = scene.AddDirectional({ 1.0, 0.0, 0.0 });
  scene.Light->SetTransformMatrix(transform);
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  gradientOpacity->AddPoint(0.0, 1.0);
  scene.Property->SetGradientOpacity(gradientOpacity);
  const auto mask = MakeUniform(VolumeGrid{ { 16, 17, 18 } });
  filter->SetMaskData(mask);

  CHECK(CountExecutions(filter, []() {}) == 0);
  const std::vector<std::function<void()>> changesOfParts = {
    [&]() { scene.Volume->Modified(); },
    [&]() { mask->Modified(); },
    [&]() { scene.Opacity->AddPoint(128.0, 0.9); },
    [&]() { gradientOpacity->AddPoint(10.0, 0.0); },
    [&]() { scene.Property->SetScalarOpacityUnitDistance(2.0); },
    [&]() { scene.Light->SetPosition(3.0, 2.0, 1.0); },
    [&]() { scene.Light->SetShadowBias(0.5); },
    [&]() { transform->SetElement(0, 1, 0.5); },
    [&]() {
      scene.AddDirectional({ 0.0, 0.0, 1.0 });
    },
    [&]() { filter->GetLights()->RemoveItem(otherLight); },
    [&]() { filter->GetClippingPlanes()->RemoveItem(otherPlane); },
    [&]() { matrix->SetElement(0, 0, 2.0); },
    [&]() { plane->SetOrigin(1.0, 1.0, 1.0); },
    [&]() { filter->AddClippingPlane(vtkNew<vtkPlane>()); },
  };
  const std::vector<std::function<void()>> changesOfItself = {
    [&]() { filter->SetCameraDirection(1.0, 0.0, 0.0); },
    [&]() { filter->CroppingOn(); },
    [&]() { filter->SetCroppingRegionPlanes(0, 5, 0, 5, 0, 5); },
    [&]() { filter->SetGradientEstimator(vtkVolumeVisibilityFilter::Sobel); },
    [&]() { filter->SetSampleDistance(0.7); },
    [&]() { filter->SetResolution(0.5); },
    [&]() { filter->SetOutputDimensions(3, 3, 3); },
    [&]() { filter->SetNegligibleVisibility(0.01); },
    [&]() { filter->PackArraysOn(); },
    [&]() { filter->RemoveAllClippingPlanes(); },
    [&]() { filter->SetMaskData(nullptr); },
    [&]() { filter->SetMatrix(nullptr); },
  };
  for (const auto& change : changesOfParts)
  {
    CAPTURE(&change - changesOfParts.data());
    CHECK(CountExecutions(filter, change) == 1);
  }
  for (const auto& change : changesOfItself)
  {
    CAPTURE(&change - changesOfItself.data());
    CHECK(CountExecutions(filter, change) == 1);
    CHECK(CountExecutions(filter, change) == 0);
  }
}
