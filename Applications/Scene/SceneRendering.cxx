#include "SceneRendering.h"

#include "SceneCamera.h"
#include "SceneLights.h"

#include <vtkCommand.h>
#include <vtkCullerCollection.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeLight.h>
#include <vtkVolumeMaterial.h>

#include <utility>

namespace penumbra
{
namespace
{
// VTK 9.1 keeps the lights that are on in an array of this many, and does not look at their count.
constexpr std::size_t MostLightsOfStockMapper = 6;
}

//------------------------------------------------------------------------------
SceneRendering::SceneRendering(const SceneDescription& scene, const SceneVoxels& voxels)
  : Scene(scene)
  , Image(voxels.Volume)
  , Box(voxels.Volume, scene.Volume.Transform)
{
  this->Volume->SetMapper(MakeMapper(scene, voxels, this->Warnings));
  this->Volume->SetProperty(MakeVolumeMaterial(scene, voxels.Environment));
  this->Renderer->AddVolume(this->Volume);
  this->Renderer->AutomaticLightCreationOff();
  // They cull by VTK's bounds, which are not where the volume is (see VolumeBox).
  this->Renderer->GetCullers()->RemoveAllItems();
  this->SetTransform();
  this->SetSurroundings();
  ApplyCamera(scene.Camera, this->Renderer->GetActiveCamera());
  this->ObserverOfFrames =
    this->Renderer->AddObserver(vtkCommand::StartEvent, this, &SceneRendering::PrepareFrame);
}

//------------------------------------------------------------------------------
SceneRendering::~SceneRendering()
{
  this->Renderer->RemoveObserver(this->ObserverOfFrames);
}

//------------------------------------------------------------------------------
vtkIlluminatedVolumeMapper* SceneRendering::GetIlluminatedMapper() const
{
  return vtkIlluminatedVolumeMapper::SafeDownCast(this->Volume->GetMapper());
}

//------------------------------------------------------------------------------
void SceneRendering::Update(const SceneDescription& scene, const EnvironmentImages& environment)
{
  const SceneDescription before = std::exchange(this->Scene, scene);
  this->Warnings.clear();
  ApplyToMapper(
    scene, vtkGPUVolumeRayCastMapper::SafeDownCast(this->Volume->GetMapper()), this->Warnings);
  if (!HaveSameMaterial(before, scene))
  {
    this->Volume->SetProperty(MakeVolumeMaterial(scene, environment));
  }
  if (before.Volume.Transform != scene.Volume.Transform)
  {
    this->SetTransform();
  }
  this->SetSurroundings();
}

//------------------------------------------------------------------------------
void SceneRendering::SetTransform()
{
  vtkNew<vtkMatrix4x4> transform;
  transform->DeepCopy(this->Scene.Volume.Transform.data());
  this->Volume->SetUserMatrix(transform);
  this->Box = VolumeBox(this->Image, this->Scene.Volume.Transform);
}

//------------------------------------------------------------------------------
void SceneRendering::SetSurroundings()
{
  this->Renderer->SetBackground(this->Scene.Image.Background.data());
  this->Renderer->SetTwoSidedLighting(this->Scene.TwoSidedLighting);
  this->SetLights();
}

//------------------------------------------------------------------------------
void SceneRendering::SetLights()
{
  while (this->Lights.size() > this->Scene.Lights.size())
  {
    this->Renderer->RemoveLight(this->Lights.back());
    this->Lights.pop_back();
  }
  while (this->Lights.size() < this->Scene.Lights.size())
  {
    this->Lights.push_back(vtkSmartPointer<vtkVolumeLight>::New());
  }
  std::size_t lightsOn = 0;
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    ApplyLight(this->Scene.Lights[i], this->Lights[i]);
    lightsOn += this->Scene.Lights[i].On ? 1 : 0;
    const bool fits =
      lightsOn <= MostLightsOfStockMapper || this->Scene.Renderer != RendererChoice::StockMapper;
    this->Renderer->RemoveLight(this->Lights[i]);
    if (fits)
    {
      this->Renderer->AddLight(this->Lights[i]);
    }
  }
  if (this->Scene.Renderer == RendererChoice::StockMapper && lightsOn > MostLightsOfStockMapper)
  {
    this->Warnings.push_back("the stock mapper takes " + std::to_string(MostLightsOfStockMapper) +
      " lights; the other " + std::to_string(lightsOn - MostLightsOfStockMapper) + " are left out");
  }
}

//------------------------------------------------------------------------------
void SceneRendering::DetachFromCamera(std::size_t index)
{
  this->Scene.Lights[index].Frame = LightFrame::Scene;
  this->Lights[index]->SetLightTypeToSceneLight();
}

//------------------------------------------------------------------------------
void SceneRendering::PrepareFrame()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const LightDescription& description = this->Scene.Lights[i];
    if (description.Frame == LightFrame::Camera && description.Type != LightType::Headlight)
    {
      PlaceInCameraFrame(description, camera, this->Lights[i]);
    }
  }
  FitClippingRange(camera, this->Box);
}

}
