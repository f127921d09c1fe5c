#include "SpeedRendering.h"

#include "RenderingError.h"
#include "Report.h"
#include "SceneDefaults.h"
#include "SceneFile.h"

#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>

namespace penumbra
{
namespace
{
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
SceneDescription DescribeSpeedScene(
  const SpeedCell& cell, const SpeedRequest& request, const SceneVoxels& voxels)
{
  SceneDescription scene = LoadScene(cell.Scene.File, request.Settings);
  const double voxel = SmallestSpacing(voxels.Volume);
  scene.Image.Size = { cell.Image, cell.Image };
  scene.SampleDistance = request.Step * voxel;
  scene.Shadows.SampleDistance = request.ShadowStep * voxel;
  ResolveScene(scene, voxels.Volume);
  SetLights(scene, request.HasOneLight ? 1 : cell.Lights);
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
  vtkIlluminatedVolumeMapper* mapper = this->Rendering.GetIlluminatedMapper();
  if (mapper)
  {
    mapper->RayCountingOn();
    this->Draw();
  }
  RenderedFrames frames;
  frames.Picture = this->Drawing.TakePicture();
  frames.OpenGLRenderer = this->Drawing.Renderer;
  const std::string report = WriteReport(frames, this->Volume, mapper, {});
  if (mapper)
  {
    mapper->RayCountingOff();
  }
  return nlohmann::json::parse(report);
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
