#include "BumpsScene.h"

#include <cmath>

namespace penumbra
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeBumps()
{
  VolumeGrid grid;
  grid.dimensions = { 8, 8, 8 };
  grid.spacing = { 1.0, 1.0, 1.3 };
  return SampleField(grid,
    [](const Point& p)
    {
      return 125.0 + 60.0 * std::sin(1.1 * p[0] + 0.4 * p[1]) * std::cos(0.9 * p[1] - 0.3) +
        45.0 * std::cos(0.8 * p[2] + 0.5 * p[0]);
    });
}

//------------------------------------------------------------------------------
ReferenceScene MakeBumpsScene()
{
  const auto material = MakeMaterial(
    { { 60.0, 0.0 }, { 110.0, 0.1 }, { 110.0, 0.3 }, { 150.0, 0.2 }, { 200.0, 0.7 } }, 2.0);
  material->ShadeOn();
  material->SetDiffuse(0.6);
  material->SetSpecular(0.3);
  material->SetSpecularPower(15.0);
  material->SetAmbient(0.1);
  ReferenceScene scene = MakeScene(MakeBumps(), material, { 0.4, 0.7, -1.0 });
  for (const Point& direction : { Point{ -0.6, -0.7, -0.4 }, Point{ 0.5, -0.2, 0.7 } })
  {
    const auto light = MakeDirectionalLight(direction);
    light->SetIntensity(0.5);
    light->SetAmbientColor(1.0, 1.0, 1.0);
    light->SetShadowToSoft();
    light->SetShadowBias(0.5);
    scene.Lights.push_back(light);
  }
  scene.Camera = MakeParallelCamera({ 3.5, 3.5, 4.5 }, { 0.4, 0.7, -1.0 }, 6.0);
  scene.Size = { 16, 16 };
  return scene;
}

}
