#include "ReflectingScene.h"

#include "SyntheticVolumes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra
{
namespace
{
// A ball with a smaller one before it, as values from 0 to 255 with a soft edge.
double TwoBalls(const Point& point)
{
  const auto ball = [&](const Point& center, double radius)
  {
    const double distance =
      std::hypot(point[0] - center[0], point[1] - center[1], point[2] - center[2]);
    return std::clamp(0.5 + (radius - distance) / 6.0, 0.0, 1.0);
  };
  return 255.0 * std::max(ball({ 20.0, 20.0, 18.0 }, 14.0), ball({ 29.0, 24.0, 31.0 }, 6.0));
}
}

//------------------------------------------------------------------------------
std::unique_ptr<IlluminatedScene> MakeReflectingScene(
  const std::function<void(vtkVolumeMaterial*)>& change)
{
  VolumeGrid grid;
  grid.dimensions = { 41, 41, 41 };
  auto scene = std::make_unique<IlluminatedScene>(SampleField(grid, TwoBalls));
  const double center[3] = { 20.0, 20.0, 20.0 };
  scene->LookFrom(0.4, 0.3, 0.85, 75.0, center);
  scene->AddDirectionalLight(-0.6, -0.7, -0.7, vtkVolumeLight::Soft);
  vtkNew<vtkVolumeMaterial> material;
  material->SetInterpolationTypeToLinear();
  material->SetScalarOpacity(scene->Opacity);
  material->SetColor(scene->Color);
  material->ShadeOn();
  material->SetAmbient(0.15);
  material->SetDiffuse(0.6);
  material->SetSpecular(0.5);
  material->SetSpecularPower(20.0);
  change(material);
  scene->Volume->SetProperty(material);
  return scene;
}

//------------------------------------------------------------------------------
vtkVolumeMaterial* GetMaterial(IlluminatedScene& scene)
{
  return vtkVolumeMaterial::SafeDownCast(scene.Volume->GetProperty());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeSky()
{
  constexpr std::array<unsigned char, 3> ground = { 90, 60, 40 };
  constexpr std::array<unsigned char, 3> sky = { 110, 160, 230 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int at = 0; at < 64 * 32; ++at, pixel += 3)
  {
    const bool sun = std::hypot(at % 64 - 44.0, at / 64 - 25.0) < 4.0;
    const auto& color = at / 64 < 16 ? ground : sky;
    std::transform(color.begin(), color.end(), pixel,
      [sun](unsigned char level) { return sun ? static_cast<unsigned char>(255) : level; });
  }
  return image;
}

}
