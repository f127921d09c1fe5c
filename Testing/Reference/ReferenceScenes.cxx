#include "ReferenceScenes.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>

#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeMaterial> MakeMaterial(const OpacityPoints& opacity, double unitDistance)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AllowDuplicateScalarsOn();
  for (const auto& [scalar, value] : opacity)
  {
    function->AddPoint(scalar, value);
  }
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  auto material = vtkSmartPointer<vtkVolumeMaterial>::New();
  material->SetScalarOpacity(function);
  material->SetColor(white);
  material->SetScalarOpacityUnitDistance(unitDistance);
  material->SetInterpolationTypeToLinear();
  material->SetAmbient(0.0);
  material->SetDiffuse(1.0);
  material->SetSpecular(0.0);
  return material;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCamera> MakeParallelCamera(
  const Point& focalPoint, const Point& direction, double scale)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  constexpr double far = 1000.0;
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  Point position;
  for (int axis = 0; axis < 3; ++axis)
  {
    position[axis] = focalPoint[axis] - far * direction[axis] / length;
  }
  camera->SetFocalPoint(focalPoint.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(std::abs(direction[1]) > 0.9 * length ? 1.0 : 0.0,
    std::abs(direction[1]) > 0.9 * length ? 0.0 : 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(scale);
  return camera;
}

//------------------------------------------------------------------------------
ReferenceScene MakeScene(vtkImageData* volume, vtkVolumeProperty* property, const Point& direction)
{
  ReferenceScene scene;
  scene.Volume = volume;
  scene.Property = property;
  Point center;
  volume->GetCenter(center.data());
  scene.Camera = MakeParallelCamera(center, direction);
  scene.Size = { 1, 1 };
  return scene;
}

//------------------------------------------------------------------------------
ReferencePixel ComputeMiddle(const ReferenceScene& scene, double tolerance)
{
  ReferenceOptions options;
  options.Tolerance = tolerance;
  return ReferenceIntegrator(scene, options).ComputePixel(0.5 * scene.Size[0], 0.5 * scene.Size[1]);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeLight> MakeDirectionalLight(const Point& direction)
{
  auto light = vtkSmartPointer<vtkVolumeLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(direction[0], direction[1], direction[2]);
  light->SetAmbientColor(0.0, 0.0, 0.0);
  light->SetDiffuseColor(1.0, 1.0, 1.0);
  light->SetSpecularColor(1.0, 1.0, 1.0);
  return light;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeLight> MakePointLight(const Point& position)
{
  auto light = MakeDirectionalLight({ 0.0, 0.0, -1.0 });
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(position[0], position[1], position[2] - 1.0);
  light->PositionalOn();
  light->SetConeAngle(180.0);
  return light;
}

//------------------------------------------------------------------------------
ReferenceScene MakePlaneScene()
{
  VolumeGrid grid;
  grid.dimensions = { 3, 3, 11 };
  grid.spacing = { 10.0, 10.0, 1.0 };
  grid.origin = { -10.0, -10.0, 0.0 };
  grid.scalarType = VTK_DOUBLE;
  const auto material = MakeMaterial({ { 5.0, 0.0 }, { 5.0, 1.0 } }, 1e-6);
  material->ShadeOn();
  ReferenceScene scene =
    MakeScene(SampleField(grid, [](const Point& p) { return 10.0 - p[2]; }), material);
  scene.TwoSidedLighting = false;
  return scene;
}

//------------------------------------------------------------------------------
std::array<double, 3> ComputePlane(ReferenceScene scene, double x, double y)
{
  scene.Camera = MakeParallelCamera({ x, y, 5.0 }, { 0.0, 0.0, -1.0 });
  const auto color = ComputeMiddle(scene, 1e-3).Color;
  return { color[0], color[1], color[2] };
}

}
