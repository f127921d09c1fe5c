#include "Catch.h"
#include "ReferenceScenes.h"

#include <cmath>

using namespace penumbra;

namespace
{
VolumeGrid MakeGrid()
{
  VolumeGrid grid;
  grid.dimensions = { 5, 5, 9 };
  grid.spacing = { 1.0, 1.0, 2.0 };
  grid.origin = { 0.0, 0.0, 10.0 };
  return grid;
}

ReferenceScene MakeBox()
{
  return MakeScene(
    SampleField(MakeGrid(), [](const Point&) { return 1.0; }), MakeMaterial({ { 0.0, 0.1 } }, 1.0));
}

double GetSeenLength(const ReferenceScene& scene)
{
  return std::log(1.0 - ComputeMiddle(scene, 1e-4).Color[3]) / std::log(0.9);
}
}

TEST_CASE("Clipping planes cut exactly, in the world")
{
  ReferenceScene scene = MakeBox();
  CHECK(GetSeenLength(scene) == Approx(16.0));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(2.0, 2.0, 15.3);
  plane->SetNormal(0.3, 0.0, -5.0);
  scene.ClippingPlanes = { plane.Get() };
  CHECK(GetSeenLength(scene) == Approx(5.3));
  scene.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  scene.Transform->SetElement(2, 3, 1.0);
  CHECK(GetSeenLength(scene) == Approx(4.3));
  vtkNew<vtkPlane> other;
  other->SetOrigin(0.0, 0.0, 12.0);
  other->SetNormal(0.0, 0.0, 1.0);
  scene.ClippingPlanes.emplace_back(other.Get());
  CHECK(GetSeenLength(scene) == Approx(3.3));
  other->SetNormal(1.0, 0.0, 0.0);
  other->SetOrigin(2.5, 0.0, 0.0);
  CHECK(ComputeMiddle(scene).Color[3] == 0.0);
}

TEST_CASE("Cropping cuts exactly, in the volume's own frame before its directions")
{
  ReferenceScene scene = MakeBox();
  scene.Cropping = { { -100.0, 100.0, 1.0, 3.0, 11.1, 19.4 } };
  CHECK(GetSeenLength(scene) == Approx(8.3));
  scene.Volume->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, -1);
  scene.Camera = MakeParallelCamera({ 2.0, 2.0, 0.0 }, { 0.0, 0.0, 1.0 });
  CHECK(GetSeenLength(scene) == Approx(8.3));
  scene.Cropping = { { -100.0, 100.0, 2.5, 3.0, 11.1, 19.4 } };
  CHECK(ComputeMiddle(scene).Color[3] == 0.0);
}

TEST_CASE("A mask hides up to halfway between voxels")
{
  ReferenceScene scene = MakeBox();
  // Of the nine voxels it leaves those at 14, 16 and 22.
  scene.Mask = SampleField(
    MakeGrid(), [](const Point& p) { return p[2] == 14.0 || p[2] == 16.0 || p[2] == 22.0; });
  CHECK(GetSeenLength(scene) == Approx(4.0 + 2.0));
}

TEST_CASE("What is hidden does not change the field beside it")
{
  VolumeGrid grid = MakeGrid();
  grid.scalarType = VTK_DOUBLE;
  const auto material = MakeMaterial({ { 0.0, 0.5 } }, 1.0);
  material->ShadeOn();
  const auto volume = SampleField(grid, [](const Point& p) { return p[0] - 0.75 * p[2]; });
  ReferenceScene scene = MakeScene(volume, material);
  scene.Lights = { MakeDirectionalLight({ 0.0, 0.0, -1.0 }) };
  scene.Cropping = { { -100.0, 100.0, -100.0, 100.0, 17.0, 19.0 } };
  scene.Mask = SampleField(grid, [](const Point& p) { return p[2] == 18.0; });
  CHECK(ComputeMiddle(scene).Color[0] == Approx(0.6 * 0.75).margin(1e-6));
}
