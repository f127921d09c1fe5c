#include "BumpsScene.h"
#include "Catch.h"

#include <vtkTransform.h>

#include <cmath>

using namespace penumbra;

namespace
{
constexpr double Tolerance = 1e-3;

std::array<double, 4> ComputeAt(const ReferenceScene& scene, double x, double y)
{
  ReferenceOptions options;
  options.Tolerance = Tolerance;
  return ReferenceIntegrator(scene, options).ComputePixel(x, y).Color;
}

/// The same picture, within what both may be off, at a few of its pixels.
void CheckSame(const ReferenceScene& scene, const ReferenceScene& other)
{
  for (const auto& [x, y] : { std::pair(8.3, 8.1), std::pair(4.5, 10.5), std::pair(11.5, 6.5) })
  {
    const auto color = ComputeAt(scene, x, y);
    const auto ofOther = ComputeAt(other, x, y);
    CHECK(color[3] > 0.05);
    for (int channel = 0; channel < 4; ++channel)
    {
      CAPTURE(x, y, channel);
      CHECK(color[channel] == Approx(ofOther[channel]).margin(2.0 * Tolerance / 255.0));
    }
  }
}

/// Camera and lights, taken along by a transformation of the world of this scale.
void MoveView(ReferenceScene& scene, vtkTransform* transform, double scale)
{
  double point[3];
  transform->TransformPoint(scene.Camera->GetPosition(), point);
  scene.Camera->SetPosition(point);
  transform->TransformPoint(scene.Camera->GetFocalPoint(), point);
  scene.Camera->SetFocalPoint(point);
  transform->TransformVector(scene.Camera->GetViewUp(), point);
  scene.Camera->SetViewUp(point);
  scene.Camera->SetParallelScale(scene.Camera->GetParallelScale() * scale);
  for (const auto& light : scene.Lights)
  {
    light->SetTransformMatrix(transform->GetMatrix());
  }
}
}

TEST_CASE("A picture does not change where the whole scene is turned and moved")
{
  const ReferenceScene scene = MakeBumpsScene();
  ReferenceScene turned = MakeBumpsScene();
  vtkNew<vtkTransform> transform;
  transform->Translate(100.0, -30.0, 7.0);
  transform->RotateWXYZ(70.0, 1.0, 2.0, -0.5);
  turned.Transform = transform->GetMatrix();
  MoveView(turned, transform, 1.0);
  CheckSame(scene, turned);
}

TEST_CASE("A picture does not change where the whole scene is scaled or mirrored")
{
  const ReferenceScene scene = MakeBumpsScene();
  ReferenceScene scaled = MakeBumpsScene();
  const double scale = GENERATE(1e-6, 3.0, 1e6);
  vtkNew<vtkTransform> transform;
  transform->Scale(scale, scale, scale);
  scaled.Transform = transform->GetMatrix();
  MoveView(scaled, transform, scale);
  CheckSame(scene, scaled);

  ReferenceScene mirrored = MakeBumpsScene();
  vtkNew<vtkTransform> mirror;
  mirror->Scale(-1.0, 1.0, 1.0);
  mirrored.Transform = mirror->GetMatrix();
  MoveView(mirrored, mirror, 1.0);
  // The camera's right is to the left then.
  for (const double x : { 5.3, 8.2 })
  {
    const auto color = ComputeAt(scene, x, 7.5);
    const auto ofMirrored = ComputeAt(mirrored, 16.0 - x, 7.5);
    CHECK(color[0] == Approx(ofMirrored[0]).margin(2.0 * Tolerance / 255.0));
  }
}

TEST_CASE("A picture does not change with the unit of length, or far from the origin")
{
  const ReferenceScene scene = MakeBumpsScene();
  ReferenceScene other = MakeBumpsScene();
  const double unit = GENERATE(1e-3, 2.54);
  const double offset = GENERATE(0.0, 1e6);
  double spacing[3];
  other.Volume->GetSpacing(spacing);
  other.Volume->SetSpacing(spacing[0] * unit, spacing[1] * unit, spacing[2] * unit);
  other.Volume->SetOrigin(offset * unit, 0.0, 0.0);
  other.Property->SetScalarOpacityUnitDistance(
    other.Property->GetScalarOpacityUnitDistance() * unit);
  vtkNew<vtkTransform> transform;
  transform->Scale(unit, unit, unit);
  transform->Translate(offset, 0.0, 0.0);
  MoveView(other, transform, unit);
  for (const auto& light : other.Lights)
  {
    auto* volumeLight = vtkVolumeLight::SafeDownCast(light);
    volumeLight->SetShadowBias(volumeLight->GetShadowBias() * unit);
  }
  CheckSame(scene, other);
}

TEST_CASE("Sheared matter has the opacity of its own lengths")
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 5 };
  const auto volume = SampleField(grid, [](const Point&) { return 1.0; });
  auto scene = MakeScene(volume, MakeMaterial({ { 0.0, 0.2 } }, 1.0));
  scene.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  // z of the own frame goes to x + z of the world: a ray along the world's z leaves along -x.
  scene.Transform->SetElement(0, 2, 1.0);
  scene.Camera = MakeParallelCamera({ 3.0, 2.0, 2.0 }, { 0.0, 0.0, -1.0 });
  // From (3, 4) it enters at the world's (3, 3) and leaves at (3, 0), aslant through the cells.
  const double length = 3.0 * std::sqrt(2.0);
  CHECK(ComputeMiddle(scene).Color[3] == Approx(1.0 - std::pow(0.8, length)).margin(1e-6));
}
