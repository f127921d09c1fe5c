#include "Catch.h"
#include "ReferenceScenes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

using namespace penumbra;

namespace
{
/// White above the horizon of +y, black below; the top row is the last of the image.
vtkSmartPointer<vtkImageData> MakeSky()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (vtkIdType pixel = 0; pixel < image->GetNumberOfPoints(); ++pixel)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      image->GetPointData()->GetScalars()->SetComponent(pixel, channel, pixel < 64 * 16 ? 0 : 1);
    }
  }
  return image;
}

ReferenceScene MakeMirror()
{
  ReferenceScene scene = MakePlaneScene();
  auto* material = vtkVolumeMaterial::SafeDownCast(scene.Property);
  material->SetReflectionModelToReflectionMap();
  material->SetEnvironmentMap(MakeSky());
  // The plane's normal goes to (0, 0.6, 0.8).
  scene.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  scene.Transform->DeepCopy(std::array<double, 16>{
    1.0, 0.0, 0.0, 0.0, 0.0, 0.8, 0.6, 0.0, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 0.0, 1.0 }
                              .data());
  scene.Camera = MakeParallelCamera({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, -1.0 });
  return scene;
}

double ComputeRed(const ReferenceScene& scene)
{
  return ComputeMiddle(scene, 0.05).Color[0];
}
}

TEST_CASE("A diffuse surface reflects what its normal sees, without lights")
{
  ReferenceScene scene = MakeMirror();
  scene.Property->SetDiffuse(0.75);
  CHECK(ComputeRed(scene) == Approx(0.75 * 0.5 * 1.6).margin(1e-4));
}

TEST_CASE("A glossy surface reflects what the mirrored direction sees")
{
  ReferenceScene scene = MakeMirror();
  scene.Property->SetDiffuse(0.0);
  scene.Property->SetSpecular(1.0);
  scene.Property->SetSpecularPower(1.0);
  // The eye's direction (0, 0, 1) mirrored is 2 0.8 (0, 0.6, 0.8) - (0, 0, 1).
  CHECK(ComputeRed(scene) == Approx(0.5 * (1.0 + 0.96)).margin(1e-4));
  // Seen from the horizon, 0.6 below the normal's plane's other side.
  scene.Camera = MakeParallelCamera({ 0.0, 3.0, 4.0 }, { 0.0, -1.0, 0.0 });
  CHECK(ComputeRed(scene) == Approx(0.5 * (1.0 + 2.0 * 0.36 - 1.0)).margin(1e-4));
}

TEST_CASE("Ambient light stays, other light of the lights does not count")
{
  ReferenceScene scene = MakeMirror();
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.25);
  const auto light = MakeDirectionalLight({ 0.0, 0.0, -1.0 });
  light->SetAmbientColor(1.0, 1.0, 1.0);
  light->SetShadowToHard();
  scene.Lights = { light };
  CHECK(ComputeRed(scene) == Approx(0.2 + 0.25 * 0.8).margin(1e-4));
}

TEST_CASE("A map that cannot be used reflects nothing, and is told")
{
  ReferenceScene scene = MakeMirror();
  vtkVolumeMaterial::SafeDownCast(scene.Property)->SetEnvironmentMap(nullptr);
  const ReferenceIntegrator integrator(scene);
  CHECK(integrator.GetWarnings().size() == 1);
  CHECK(integrator.ComputePixel(0.5, 0.5).Color[0] == 0.0);
}
