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
  , Box(voxels.Volume, scene.Volume.Transform)
{
  this->Volume->SetMapper(MakeMapper(scene, voxels, this->Warnings));
  this->Volume->SetProperty(MakeVolumeMaterial(scene, voxels.Environment));
  vtkNew<vtkMatrix4x4> transform;
  transform->DeepCopy(scene.Volume.Transform.data());
  this->Volume->SetUserMatrix(transform);

  this->Renderer->AddVolume(this->Volume);
  this->Renderer->SetBackground(scene.Image.Background.data());
  this->Renderer->SetTwoSidedLighting(scene.TwoSidedLighting);
  this->Renderer->AutomaticLightCreationOff();
  // They cull by VTK's bounds, which are not where the volume is (see VolumeBox).
  this->Renderer->GetCullers()->RemoveAllItems();
  this->AddLights();
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
void SceneRendering::AddLights()
{
  std::size_t lightsOn = 0;
  for (const LightDescription& description : this->Scene.Lights)
  {
    this->Lights.push_back(MakeLight(description));
    lightsOn += description.On ? 1 : 0;
    const bool fits =
      lightsOn <= MostLightsOfStockMapper || this->Scene.Renderer != RendererChoice::StockMapper;
    if (fits)
    {
      this->Renderer->AddLight(this->Lights.back());
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
