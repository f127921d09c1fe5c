#include "PresetThumbnails.h"

#include "OffscreenView.h"
#include "PictureImage.h"
#include "SceneRendering.h"
#include "VisibleView.h"
#include "VolumeBox.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkNew.h>

#include <algorithm>
#include <exception>

namespace penumbra
{
namespace
{
// Voxels along an axis that a thumbnail's pixels still show.
constexpr int MostVoxels = 96;
constexpr int MillisecondsBetween = 30;

vtkSmartPointer<vtkImageData> MakeCoarse(vtkImageData* volume)
{
  int size[3];
  volume->GetDimensions(size);
  for (int& count : size)
  {
    count = std::min(count, MostVoxels);
  }
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(volume);
  resize->SetOutputDimensions(size);
  resize->Update();
  auto coarse = vtkSmartPointer<vtkImageData>::New();
  coarse->ShallowCopy(resize->GetOutput());
  coarse->SetDirectionMatrix(volume->GetDirectionMatrix());
  coarse->GetFieldData()->ShallowCopy(volume->GetFieldData());
  return coarse;
}
}

//------------------------------------------------------------------------------
PresetThumbnails::PresetThumbnails(QObject* parent)
  : QObject(parent)
{
  this->Timer.setInterval(MillisecondsBetween);
  this->connect(&this->Timer, &QTimer::timeout, this, &PresetThumbnails::DrawNext);
}

//------------------------------------------------------------------------------
PresetThumbnails::~PresetThumbnails()
{
  this->Stop();
}

//------------------------------------------------------------------------------
void PresetThumbnails::Start(
  const SceneDescription& scene, vtkImageData* volume, const std::vector<PresetName>& presets)
{
  this->Stop();
  this->Presets = presets;
  this->Next = 0;
  this->Scene = scene;
  this->Scene.Image.Size = { Size, Size };
  this->Voxels.Volume = volume;
  this->Timer.start();
}

//------------------------------------------------------------------------------
void PresetThumbnails::Stop()
{
  this->Timer.stop();
  if (this->View)
  {
    this->View->SetRendering(nullptr);
  }
  this->View.reset();
  this->Rendering.reset();
  this->Statistics.reset();
  this->Voxels = {};
}

//------------------------------------------------------------------------------
SceneDescription PresetThumbnails::SceneOf(const std::string& preset) const
{
  SceneDescription scene = this->Scene;
  ApplyPreset(preset, {}, this->Voxels.Volume, *this->Statistics, scene);
  scene.SampleDistance = 0.5 * SmallestSpacing(this->Voxels.Volume);
  scene.Shadows.SampleDistance = 4.0 * *scene.SampleDistance;
  ViewFromTheFront(scene, this->Voxels.Volume);
  return scene;
}

//------------------------------------------------------------------------------
void PresetThumbnails::DrawNext()
{
  if (this->Next == this->Presets.size())
  {
    this->Stop();
    return;
  }
  try
  {
    if (!this->Statistics)
    {
      this->Voxels.Volume = MakeCoarse(this->Voxels.Volume);
      this->Statistics.emplace(this->Voxels.Volume);
      this->View = std::make_unique<OffscreenView>();
    }
    const SceneDescription scene = this->SceneOf(this->Presets[this->Next].Name);
    this->View->SetRendering(nullptr);
    this->Rendering = std::make_unique<SceneRendering>(scene, this->Voxels);
    this->View->SetRendering(this->Rendering.get());
    emit this->drawn(
      static_cast<int>(this->Next), ToQImage(this->View->TakePicture({ Size, Size })));
    ++this->Next;
  }
  catch (const std::exception&)
  {
    this->Stop(); // the presets do without pictures
  }
}

}
