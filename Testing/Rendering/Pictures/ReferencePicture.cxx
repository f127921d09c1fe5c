#include "ReferencePicture.h"

#include "ReferenceIntegrator.h"

#include <vtkCamera.h>
#include <vtkLightCollection.h>
#include <vtkPlaneCollection.h>

#include <algorithm>

namespace penumbra
{
namespace
{
ReferenceScene MakeReferenceScene(IlluminatedScene& scene)
{
  vtkIlluminatedVolumeMapper* mapper = scene.Mapper;
  ReferenceScene reference;
  reference.Volume = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  reference.Mask = mapper->GetMaskInput();
  reference.Transform = scene.Volume->GetMatrix();
  if (mapper->GetCropping())
  {
    reference.Cropping.emplace();
    mapper->GetCroppingRegionPlanes(reference.Cropping->data());
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    for (int plane = 0; plane < planes->GetNumberOfItems(); ++plane)
    {
      reference.ClippingPlanes.emplace_back(planes->GetItem(plane));
    }
  }
  reference.Property = scene.Volume->GetProperty();
  reference.Gradient = static_cast<GradientEstimator>(mapper->GetGradientEstimator());
  vtkLightCollection* lights = scene.Renderer->GetLights();
  for (int light = 0; light < lights->GetNumberOfItems(); ++light)
  {
    reference.Lights.emplace_back(vtkLight::SafeDownCast(lights->GetItemAsObject(light)));
  }
  reference.TwoSidedLighting = scene.Renderer->GetTwoSidedLighting() != 0;
  reference.Camera = scene.Renderer->GetActiveCamera();
  const int* size = scene.Window->GetSize();
  reference.Size = { size[0], size[1] };
  scene.Renderer->GetBackground(reference.Background.data());
  return reference;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> RenderReference(IlluminatedScene& scene)
{
  const ReferencePicture picture = ReferenceIntegrator(MakeReferenceScene(scene)).Render().value();
  auto colors = vtkSmartPointer<vtkImageData>::New();
  colors->SetDimensions(picture.Colors->GetDimensions());
  colors->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* from = static_cast<float*>(picture.Colors->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(colors->GetScalarPointer());
  for (vtkIdType pixel = 0; pixel < colors->GetNumberOfPoints(); ++pixel)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const float value = std::clamp(from[4 * pixel + channel], 0.0f, 1.0f);
      to[3 * pixel + channel] = static_cast<unsigned char>(255.0f * value + 0.5f);
    }
  }
  return colors;
}

}
