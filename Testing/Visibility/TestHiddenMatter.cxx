#include "Catch.h"
#include "PartlyHidden.h"

#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>

#include <algorithm>

using namespace penumbra;

namespace
{
/// One directional light, from above unless a test says otherwise.
void Light(ShadowedVolume& scene, const Point& towardsLight = { 0.0, 0.0, 1.0 })
{
  scene.SetExtinction(Extinction);
  scene.AddDirectional(towardsLight);
}

vtkSmartPointer<vtkPlane> MakePlane(const Point& origin, const Point& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  return plane;
}
}

// The volume's top is at z = 11.
TEST_CASE("Matter behind a clipping plane casts no shadow, exactly from the plane on")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  Light(scene);
  SECTION("the upper part is hidden")
  {
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 7.3 }, { 0.0, 0.0, -2.0 }));
    CHECK(
      GetLargestError(scene, [](const Point& point) { return Dim(7.3 - point[2]); }) < Rounding);
  }
  SECTION("the lower part is hidden: points in it see what is above")
  {
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 7.3 }, { 0.0, 0.0, 1.0 }));
    CHECK(GetLargestError(scene,
            [](const Point& point) { return Dim(11.0 - std::max(point[2], 7.3)); }) < Rounding);
  }
  SECTION("two planes leave a slab")
  {
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 9.1 }, { 0.0, 0.0, -1.0 }));
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 7.3 }, { 0.0, 0.0, 1.0 }));
    CHECK(GetLargestError(scene,
            [](const Point& point) { return Dim(9.1 - std::max(point[2], 7.3)); }) < Rounding);
  }
  SECTION("an oblique plane")
  {
    scene.Filter->AddClippingPlane(MakePlane({ 2.0, 0.0, 7.0 }, { 0.5, 0.0, -1.0 }));
    CHECK(GetLargestError(scene,
            [](const Point& point)
            {
              const double top = std::min(7.0 + 0.5 * (point[0] - 2.0), 11.0);
              return Dim(top - point[2]);
            }) < Rounding);
  }
  SECTION("planes that leave nothing")
  {
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 7.3 }, { 0.0, 0.0, -1.0 }));
    scene.Filter->AddClippingPlane(MakePlane({ 0.0, 0.0, 9.1 }, { 0.0, 0.0, 1.0 }));
    CHECK(GetLargestError(scene, [](const Point&) { return 1.0; }) == 0.0);
  }
}

TEST_CASE("Clipping planes are in the world")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  Light(scene);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(2, 2, 2.0);
  matrix->SetElement(2, 3, 100.0);
  scene.Filter->SetMatrix(matrix);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(MakePlane({ 0.0, 0.0, 2.0 * 7.3 + 100.0 }, { 0.0, 0.0, -1.0 }));
  scene.Filter->SetClippingPlanes(planes);
  CHECK(GetLargestError(scene, [](const Point& point) { return Dim(7.3 - point[2]); }) < Rounding);
}

TEST_CASE("The border of a clipping plane belongs to what is seen, along the whole of a ray")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  Light(scene);
  scene.Filter->AddClippingPlane(MakePlane({ 5.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }));
  CHECK(
    GetLargestError(scene,
      [](const Point& point) { return point[0] < 4.99 ? 1.0 : Dim(11.0 - point[2]); }) < Rounding);
}

TEST_CASE("Planes and lights are where they are for a volume whose extent begins anywhere")
{
  const VolumeGrid grid = MakeGrid();
  const auto volume = MakeUniform(grid);
  volume->SetExtent(3, 11, -4, 3, 7, 23);
  volume->SetOrigin(2.0 - 3.0, -1.0 + 4 * 1.2, 3.0 - 7 * 0.5);
  ShadowedVolume scene(volume);
  scene.SetExtinction(Extinction);
  const Point light = { 5.5, 1.4, 30.0 };
  scene.AddPoint(light);
  const auto dim = [&](const Point& point, double top)
  { return Dim(Length(light - point) * (top - point[2]) / (light[2] - point[2])); };
  CHECK(GetLargestError(scene, [&](const Point& point) { return dim(point, 11.0); }) < Rounding);
  // In either order.
  scene.Filter->SetCroppingRegionPlanes(-10.0, 20.0, -10.0, 20.0, 7.3, -10.0);
  scene.Filter->CroppingOn();
  CHECK(GetLargestError(scene,
          [&](const Point& point) { return dim(point, std::max(point[2], 7.3)); }) < Rounding);
}

TEST_CASE("Cropped matter casts no shadow, exactly from the border on")
{
  ShadowedVolume scene(MakeUniform(MakeGrid()));
  Light(scene);
  scene.Filter->SetCroppingRegionPlanes(3.5, 8.1, -10.0, 10.0, 5.3, 8.4);
  CHECK(GetLargestError(scene, [](const Point& point) { return Dim(11.0 - point[2]); }) < Rounding);
  scene.Filter->CroppingOn();
  CHECK(GetLargestError(scene,
          [](const Point& point)
          {
            const bool inside = point[0] > 3.5 && point[0] < 8.1;
            return inside ? Dim(8.4 - std::max(point[2], 5.3)) : 1.0;
          }) < Rounding);
}
