#include "ViewDrawing.h"

#include "MovingSettings.h"
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
constexpr double LongestQuickFrame = 0.3;
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
  this->Quality.NoteFrame(AssumedSecondsOfFrame, 0.0, 1);
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
  return this->SceneChanged || !this->ShadowsKept ||
    std::any_of(lights.begin(), lights.end(), followsCamera);
}

//------------------------------------------------------------------------------
bool ViewDrawing::AreWholeFramesFluid() const
{
  const double rate = this->Widget->interactor()->GetDesiredUpdateRate();
  return this->SecondsOfLastWholeFrame > 0.0 && this->SecondsOfLastWholeFrame <= 1.0 / rate;
}

//------------------------------------------------------------------------------
int ViewDrawing::FindMovingDistance() const
{
  return this->Quality.FindDistance(this->Widget->interactor()->GetDesiredUpdateRate());
}

//------------------------------------------------------------------------------
// Where a whole frame takes long, one comes before that does not. None: 0.
int ViewDrawing::FindQuickDistance() const
{
  const int quick = this->Quality.FindDistance(1.0 / LongestQuickFrame);
  return this->SecondsOfLastWholeFrame > LongestFrame && quick < this->Distance ? quick : 0;
}

//------------------------------------------------------------------------------
void ViewDrawing::SetRayDistance(int distance)
{
  MapperOf(this->Rendering)->SetImageSampleDistance(static_cast<float>(distance));
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawBy(const std::function<void()>& draw)
{
  this->EndStrips();
  if (!this->Rendering)
  {
    draw();
    return;
  }
  const MovingSettings settings(this->Rendering->GetIlluminatedMapper(), this->ShadowsChange());
  this->SetRayDistance(this->FindMovingDistance());
  draw();
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawMoving()
{
  if (this->AreWholeFramesFluid())
  {
    this->DrawWhole();
    emit this->moved();
    return;
  }
  this->DrawCoarsely(this->FindMovingDistance());
  emit this->moved();
  this->RefineTimer.start(StillMilliseconds);
}

//------------------------------------------------------------------------------
void ViewDrawing::Refine()
{
  if (QApplication::mouseButtons() != Qt::NoButton)
  {
    this->RefineTimer.start(StillMilliseconds); // what is held still may yet move
    return;
  }
  const int quick = this->FindQuickDistance();
  if (quick == 0)
  {
    this->BeginStrips();
    return;
  }
  this->DrawCoarsely(quick);
  this->RefineTimer.start(LongStillMilliseconds);
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawWhole()
{
  if (!this->CanDraw())
  {
    return;
  }
  this->EndStrips();
  this->SetRayDistance(1);
  this->Finish(this->Render());
}

//------------------------------------------------------------------------------
void ViewDrawing::DrawCoarsely(int distance)
{
  if (!this->CanDraw())
  {
    return;
  }
  auto* const mapper = this->Rendering->GetIlluminatedMapper();
  const int updates = mapper ? mapper->GetNumberOfShadowUpdates() : 0;
  double seconds = 0.0;
  this->DrawBy(
    [&]
    {
      this->SetRayDistance(distance);
      seconds = this->Render();
    });
  const bool updated = mapper && mapper->GetNumberOfShadowUpdates() > updates;
  this->Quality.NoteFrame(seconds, updated ? mapper->GetShadowUpdateSeconds() : 0.0, distance);
  this->Distance = distance;
}

//------------------------------------------------------------------------------
double ViewDrawing::Render()
{
  this->Decorations->FitScaleBar();
  const auto before = std::chrono::steady_clock::now();
  this->Widget->renderWindow()->Render();
  this->Widget->renderWindow()->WaitForCompletion();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  return passed.count();
}

//------------------------------------------------------------------------------
void ViewDrawing::BeginStrips()
{
  const bool seen = this->CanDraw() && this->Rendering->GetVolume()->GetVisibility();
  auto* const mapper = seen ? this->Rendering->GetIlluminatedMapper() : nullptr;
  const double seconds = this->SecondsOfLastWholeFrame > 0.0
    ? this->SecondsOfLastWholeFrame
    : this->Quality.GetSecondsOfWholeFrame();
  const int strips = static_cast<int>(std::ceil(seconds / SecondsOfStrip));
  if (!mapper || strips < 2)
  {
    this->DrawWhole();
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
  this->Quality.NoteStill(seconds);
  this->Distance = 1;
  this->SceneChanged = false;
  auto* const mapper = this->Rendering->GetIlluminatedMapper();
  this->ShadowsKept = mapper && mapper->GetShadowBytes() > 0;
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
  this->DrawWhole();
  const auto picture = ReadPicture(this->Widget->renderWindow());
  this->ShowOver(true);
  this->Schedule(false);
  return picture;
}

}
