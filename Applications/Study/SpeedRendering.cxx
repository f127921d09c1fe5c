#include "SpeedRendering.h"

#include "RenderingError.h"
#include "Report.h"
#include "SceneDefaults.h"
#include "SceneFile.h"

#include <vtkFieldData.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

namespace penumbra
{
namespace
{
// The volume keeps its bounds: its first and last voxels along each axis stay where they are.
vtkSmartPointer<vtkImageData> Resample(vtkImageData* volume, int edge)
{
  const int* size = volume->GetDimensions();
  const int longest = *std::max_element(size, size + 3);
  if (edge == longest || longest == 1)
  {
    return volume;
  }
  int resampled[3];
  std::transform(size, size + 3, resampled,
    [&](int count)
    { return static_cast<int>(std::lround((count - 1.0) * (edge - 1.0) / (longest - 1.0))) + 1; });
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(volume);
  resize->SetResizeMethodToOutputDimensions();
  resize->SetOutputDimensions(resampled);
  resize->Update();
  vtkImageData* output = resize->GetOutput();
  // What the filter drops: how the volume lies, and its modality, by which a look is chosen.
  output->SetDirectionMatrix(volume->GetDirectionMatrix());
  output->SetFieldData(volume->GetFieldData());
  return output;
}

// A headlight is one direction of the camera's frame.
void FixHeadlight(LightDescription& light)
{
  if (light.Type == LightType::Headlight)
  {
    light.Type = LightType::Directional;
    light.Frame = LightFrame::Camera;
    light.Direction = { 0.0, 0.0, -1.0 };
  }
}

// Copies of the first light stand around the volume, and together are as bright.
void SetLights(SceneDescription& scene, int count)
{
  LightDescription first =
    scene.Lights.empty() ? SceneDescription::DefaultLight() : scene.Lights.front();
  first.On = true;
  if (count > 1)
  {
    FixHeadlight(first);
    first.Intensity /= count;
  }
  scene.Lights.assign(static_cast<std::size_t>(count), first);
  const bool followsCamera = first.Frame == LightFrame::Camera;
  const Vector3 up = UnitVector(followsCamera ? Vector3{ 0.0, 1.0, 0.0 } : *scene.Camera.ViewUp);
  const Vector3 center = followsCamera ? Vector3{ 0.0, 0.0, 0.0 } : *scene.Camera.FocalPoint;
  for (int light = 1; light < count; ++light)
  {
    const double angle = vtkMath::RadiansFromDegrees(360.0 * light / count);
    LightDescription& copy = scene.Lights[static_cast<std::size_t>(light)];
    copy.Direction = Rotated(first.Direction, up, angle);
    copy.Position = Sum(center, Rotated(Difference(first.Position, center), up, angle));
  }
}
}

//------------------------------------------------------------------------------
SceneVoxels ReadSpeedVoxels(const SpeedCell& cell, const std::filesystem::path& dicomParser)
{
  const SceneDescription scene = LoadScene(cell.Scene.File, {});
  std::vector<std::string> warnings;
  SceneVoxels voxels = ReadVoxels(scene.Volume, { dicomParser, {} }, warnings);
  voxels.Environment = ReadEnvironmentImages(scene.Material);
  if (cell.Edge > 0)
  {
    voxels.Volume = Resample(voxels.Volume, cell.Edge);
    // A mask says which voxels are hidden, of which there are others now.
    voxels.Mask = nullptr;
  }
  return voxels;
}

//------------------------------------------------------------------------------
SceneDescription DescribeSpeedScene(
  const SpeedCell& cell, const SpeedRequest& request, const SceneVoxels& voxels)
{
  SceneDescription scene = LoadScene(cell.Scene.File, request.Settings);
  const double voxel = SmallestSpacing(voxels.Volume);
  scene.Image.Size = { cell.Image, cell.Image };
  scene.SampleDistance = request.Step * voxel;
  scene.Shadows.SampleDistance = request.ShadowStep * voxel;
  ResolveScene(scene, voxels.Volume);
  SetLights(scene, cell.Lights);
  ResolveScene(scene, voxels.Volume);
  return scene;
}

//------------------------------------------------------------------------------
SpeedRendering::SpeedRendering(const SceneDescription& scene, const SceneVoxels& voxels)
  : Rendering(scene, voxels)
  , Volume(voxels.Volume)
  , Window(MakeWindow(this->Rendering, scene.Image.Size))
  , Drawing(DrawInWindow(this->Window))
{
}

//------------------------------------------------------------------------------
FrameTime SpeedRendering::Draw()
{
  this->Messages->Install();
  const FrameTime time = TimeFrame(this->Drawing);
  if (!this->Messages->GetErrors().empty())
  {
    throw RenderingError(this->Messages->GetErrors().front());
  }
  return time;
}

//------------------------------------------------------------------------------
FrameTime SpeedRendering::DrawAfter(SceneChange change)
{
  ChangeScene(this->Rendering, change);
  return this->Draw();
}

//------------------------------------------------------------------------------
StudyPicture SpeedRendering::TakePicture() const
{
  return ToStudyPicture(this->Drawing.TakePicture());
}

//------------------------------------------------------------------------------
nlohmann::json SpeedRendering::Report()
{
  RenderedFrames frames;
  frames.Picture = this->Drawing.TakePicture();
  frames.OpenGLRenderer = this->Drawing.Renderer;
  return nlohmann::json::parse(
    WriteReport(frames, this->Volume, this->Rendering.GetIlluminatedMapper(), {}));
}

//------------------------------------------------------------------------------
std::vector<std::string> SpeedRendering::GetWarnings() const
{
  std::vector<std::string> warnings = this->Rendering.GetWarnings();
  if (vtkIlluminatedVolumeMapper* mapper = this->Rendering.GetIlluminatedMapper())
  {
    const std::vector<std::string>& messages = mapper->GetMessages();
    warnings.insert(warnings.end(), messages.begin(), messages.end());
  }
  return warnings;
}

}
