#include "SceneReference.h"

#include "SceneRendering.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeLight.h>

namespace penumbra
{

//------------------------------------------------------------------------------
ReferenceScene MakeReferenceScene(
  const SceneDescription& scene, const SceneVoxels& voxels, SceneRendering& rendering)
{
  vtkRenderer* renderer = rendering.GetRenderer();
  // Lights of the camera's frame follow it at the start of a frame.
  renderer->InvokeEvent(vtkCommand::StartEvent);
  ReferenceScene reference;
  reference.Volume = voxels.Volume;
  reference.Mask = voxels.Mask;
  reference.Transform = vtkSmartPointer<vtkMatrix4x4>::New();
  reference.Transform->DeepCopy(scene.Volume.Transform.data());
  reference.Cropping = scene.Volume.Cropping;
  for (const ClippingPlaneDescription& description : scene.ClippingPlanes)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(description.Origin.data());
    plane->SetNormal(UnitVector(description.Normal).data());
    reference.ClippingPlanes.emplace_back(plane);
  }
  reference.Property = rendering.GetVolume()->GetProperty();
  reference.Optics = scene.Optics;
  reference.Gradient = scene.Gradient;
  reference.Lights.assign(rendering.GetLights().begin(), rendering.GetLights().end());
  reference.TwoSidedLighting = scene.TwoSidedLighting;
  reference.Camera = renderer->GetActiveCamera();
  reference.Size = scene.Image.Size;
  reference.Background = scene.Image.Background;
  return reference;
}

}
