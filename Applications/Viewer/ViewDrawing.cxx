#include "ViewDrawing.h"

#include "Picture.h"
#include "SceneDocument.h"
#include "SceneRendering.h"
#include "ViewDecorations.h"
#include "ViewOverlay.h"

#include <QApplication>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace penumbra
{
namespace
{
// Of a volume that was not drawn yet, whose first picture is to be there soon.
constexpr double AssumedSecondsOfFrame = 2.0;
// Nothing moves when it has not for so long.
constexpr int StillMilliseconds = 250;
// Before whole frames that take longer than this many seconds come quick ones.
constexpr double LongestFrame = 3.0;
constexpr double LongestQuickFrame = 1.0;
constexpr int LongStillMilliseconds = 1000;
// A strip of a whole frame is to take no longer than people notice as a delay. Each costs some time
// of its own.
constexpr double SecondsOfStrip = 0.1;
constexpr int MostStrips = 40;

vtkGPUVolumeRayCastMapper* MapperOf(SceneRendering* rendering)
{
  return vtkGPUVolumeRayCastMapper::SafeDownCast(rendering->GetVolume()->GetMapper());
}
}

//------------------------------------------------------------------------------
ViewDrawing::ViewDrawing(QVTKOpenGLNativeWidget* widget, const SceneDocument* document)
  : Widget(widget)
  , Document(document)
{
  for (QTimer* timer : { &this->FrameTimer, &this->RefineTimer, &this->StripTimer })
  {
    timer->setSingleShot(true);
  }
  this->connect(&this->FrameTimer, &QTimer::timeout, this, &ViewDrawing::DrawMoving);
  this->connect(&this->RefineTimer, &QTimer::timeout, this, &ViewDrawing::Refine);
  this->connect(&this->StripTimer, &QTimer::timeout, this, &ViewDrawing::DrawStrip);
}

//------------------------------------------------------------------------------
void ViewDrawing::SetRendering(SceneRendering* rendering)
{
  this->EndStrips();
  this->Rendering = rendering;
  this->Quality.NoteFrame(AssumedSecondsOfFrame, 1);
  this->SecondsOfLastWholeFrame = 0.0;
}

//------------------------------------------------------------------------------
void ViewDrawing::SetOver(ViewDecorations* decorations, ViewOverlay* overlay)
{
  this->Decorations = decorations;
  this->Overlay = overlay;
}

//------------------------------------------------------------------------------
void ViewDrawing::Schedule(bool sceneChanged)
{
  this->EndStrips();
  this->SceneChanged = this->SceneChanged || sceneChanged;
  this->Refined = false;
  if (this->Rendering && !this->FrameTimer.isActive())
  {
    this->FrameTimer.start();
  }
}

//------------------------------------------------------------------------------
bool ViewDrawing::CanDraw() const
{
  return this->Rendering && this->Widget->isValid();
}

//------------------------------------------------------------------------------
bool ViewDrawing::ShadowsChange() const
{
  const auto& lights = this->Document->GetScene().Lights;
  const auto followsCamera = [](const LightDescription& light)
  {
    return light.On && light.Shadow != ShadowKind::None &&
      (light.Frame == LightFrame::Camera || light.Type == LightType::Headlight);
  };
  return this->SceneChanged || std::any_of(lights.begin(), lights.end(), followsCamera);
}

//------------------------------------------------------------------------------
int ViewDrawing::FindMovingDistance() const
{
  return this->Quality.FindDistance(this->Widget->interactor()->GetDesiredUpdateRate());
}

//------------------------------------------------------------------------------
int ViewDrawing::FindStillDistance() const
{
  // Where a whole frame takes long, one comes before that does not.
  if (this->SecondsOfLastWholeFrame <= LongestFrame)
  {
    return 1;
  }
  const int quick = this->Quality.FindDistance(1.0 / LongestQuickFrame);
  return quick < this->Distance ? quick : 1;
}

//------------------------------------------------------------------------------
void ViewDrawing::SetRayDistance(int distance)
{
  if (this->Rendering)
  {
    MapperOf(this->Rendering)->SetImageSampleDistance(static_cast<float>(distance));
  }
}

//------------------------------------------------------------------------------
void ViewDrawing::UseMovingDistance()
{
  this->EndStrips();
  this->SetRayDistance(this->FindMovingDistance());
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawMoving()
{
  const int distance = this->FindMovingDistance();
  this->Draw(distance);
  emit this->moved();
  if (distance > 1)
  {
    this->RefineTimer.start(StillMilliseconds);
  }
}

//------------------------------------------------------------------------------
void ViewDrawing::Refine()
{
  if (QApplication::mouseButtons() != Qt::NoButton)
  {
    this->RefineTimer.start(StillMilliseconds); // what is held still may yet move
    return;
  }
  const int distance = this->FindStillDistance();
  if (distance == 1)
  {
    this->BeginStrips();
    return;
  }
  this->Draw(distance);
  this->RefineTimer.start(LongStillMilliseconds);
}

//------------------------------------------------------------------------------
void ViewDrawing::Draw(int distance)
{
  if (!this->CanDraw())
  {
    return;
  }
  this->EndStrips();
  this->Decorations->FitScaleBar();
  const auto before = std::chrono::steady_clock::now();
  this->Render(distance);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  this->Quality.NoteFrame(passed.count(), distance);
  this->Distance = distance;
  if (distance == 1)
  {
    this->Finish(passed.count());
  }
}

//------------------------------------------------------------------------------
void ViewDrawing::Render(int distance)
{
  this->SetRayDistance(distance);
  // What is kept of shadows would have to be made anew for a frame that is soon outdated.
  auto* const mapper =
    distance > 1 && this->ShadowsChange() ? this->Rendering->GetIlluminatedMapper() : nullptr;
  const int technique = mapper ? mapper->GetShadowTechnique() : 0;
  if (mapper)
  {
    mapper->SetShadowTechniqueToRays();
  }
  this->Widget->renderWindow()->Render();
  this->Widget->renderWindow()->WaitForCompletion();
  if (mapper)
  {
    mapper->SetShadowTechnique(technique);
  }
}

//------------------------------------------------------------------------------
void ViewDrawing::BeginStrips()
{
  auto* const mapper = this->CanDraw() ? this->Rendering->GetIlluminatedMapper() : nullptr;
  const double seconds = this->SecondsOfLastWholeFrame > 0.0
    ? this->SecondsOfLastWholeFrame
    : this->Quality.GetSecondsOfWholeFrame();
  const int strips = static_cast<int>(std::ceil(seconds / SecondsOfStrip));
  if (!mapper || strips < 2)
  {
    this->Draw(1);
    return;
  }
  this->SetRayDistance(1);
  this->ShowOver(false);
  this->Widget->setUpdatesEnabled(false); // until the frame is whole
  this->Still.Begin(this->Rendering->GetRenderer(), mapper, std::min(strips, MostStrips));
  this->StripTimer.start();
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawStrip()
{
  if (!this->Still.DrawNext())
  {
    this->StripTimer.start();
    return;
  }
  const double seconds = this->Still.GetSeconds();
  this->ShowOver(true);
  this->Decorations->FitScaleBar();
  this->Still.DrawOver();
  this->EndStrips();
  this->Quality.NoteFrame(seconds, 1);
  this->Distance = 1;
  this->Finish(seconds);
}

//------------------------------------------------------------------------------
void ViewDrawing::EndStrips()
{
  if (this->Still.IsRunning())
  {
    this->StripTimer.stop();
    this->Still.End();
    this->ShowOver(true);
    this->Widget->setUpdatesEnabled(true);
  }
}

//------------------------------------------------------------------------------
void ViewDrawing::Finish(double seconds)
{
  this->RefineTimer.stop();
  this->SecondsOfLastWholeFrame = seconds;
  this->SceneChanged = false;
  this->Refined = true;
  emit this->refined(seconds);
}

//------------------------------------------------------------------------------
void ViewDrawing::ShowOver(bool shown)
{
  this->Decorations->Hide(!shown);
  this->Overlay->Show(shown);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ViewDrawing::TakePicture()
{
  this->FrameTimer.stop();
  this->EndStrips();
  this->ShowOver(false);
  this->Draw(1);
  const auto picture = ReadPicture(this->Widget->renderWindow());
  this->ShowOver(true);
  this->Schedule(false);
  return picture;
}

}
