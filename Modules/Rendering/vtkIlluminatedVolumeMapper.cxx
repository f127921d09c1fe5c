#include "vtkIlluminatedVolumeMapper.h"

#include "PicturePreparation.h"
#include "PictureRequest.h"
#include "StepPreparation.h"
#include "StockLights.h"
#include "TakenOver.h"
#include "vtkIlluminatedVolumeMapperInternals.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>

using namespace penumbra;

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkIlluminatedVolumeMapper);

//------------------------------------------------------------------------------
vtkIlluminatedVolumeMapper::vtkIlluminatedVolumeMapper()
  : Internal(std::make_unique<Internals>())
{
  this->SampleDistance = 0.0f;
}

//------------------------------------------------------------------------------
vtkIlluminatedVolumeMapper::~vtkIlluminatedVolumeMapper() = default;

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::SetGradientTextureBits(int bits)
{
  const int allowed = bits < 0 ? AutomaticGradientTexture : bits == 0 ? 0 : bits <= 8 ? 8 : 16;
  if (allowed != this->GradientTextureBits)
  {
    this->GradientTextureBits = allowed;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Say(const std::string& message)
{
  this->Internal->Messages.push_back(message);
  if (this->Internal->MessagesGiven.insert(message).second)
  {
    vtkWarningMacro(<< message);
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::GPURender(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Internal->Messages.clear();
  this->Internal->Counts = {};
  this->Internal->ShadowsComplete = true;
  this->MoveTo(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(this->GetDataSetInput(), this->ScalarMode,
    this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  const std::string notTakenOver =
    FindWhatIsNotTakenOver(this, scalars, cellFlag != 0, renderer, volume);
  if (notTakenOver.empty())
  {
    this->DrawIlluminated(renderer, volume, scalars);
    return;
  }
  // Picking is the stock ray caster's business without anything being amiss.
  if (!renderer->GetSelector())
  {
    this->Say(
      notTakenOver + " is drawn by the stock ray caster, without Penumbra's light and shadow.");
  }
  this->DrawStock(renderer, volume);
}

//------------------------------------------------------------------------------
// The stock ray caster does not end on a sample distance of 0 and, adjusting, takes another one
// than is asked.
void vtkIlluminatedVolumeMapper::DrawStock(vtkRenderer* renderer, vtkVolume* volume)
{
  const StockLights lights(renderer->GetLights());
  if (lights.AreSomeLeftOut())
  {
    this->Say("The stock ray caster takes six lights; the others are left out.");
  }
  const auto askedToAdjust = this->AutoAdjustSampleDistances;
  this->AutoAdjustSampleDistances = 0;
  const float askedSampleDistance = this->SampleDistance;
  this->SampleDistance = static_cast<float>(GetSampleDistances(this).View);
  this->Superclass::GPURender(renderer, volume);
  this->SampleDistance = askedSampleDistance;
  this->AutoAdjustSampleDistances = askedToAdjust;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::DrawIlluminated(
  vtkRenderer* renderer, vtkVolume* volume, vtkDataArray* scalars)
{
  Internals& internal = *this->Internal;
  internal.Window->MakeCurrent();
  PictureRequest request;
  request.Mapper = this;
  request.Renderer = renderer;
  request.Window = internal.Window;
  request.Volume = volume;
  request.Property = volume->GetProperty();
  request.Image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  request.Scalars = scalars;
  request.Moving = this->AutoAdjustSampleDistances &&
    InteractiveResolution::IsInteractive(volume->GetAllocatedRenderTime());
  std::vector<std::string> messages;
  internal.Drawing.SetShadowSeconds(this->ShadowUpdateTime);
  const std::string fault =
    PreparePicture(request, internal.Scene, internal.Shadows, internal.Drawing, messages);
  for (const std::string& message : messages)
  {
    this->Say(message);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
  }
  else if (internal.Scene.AnythingVisible)
  {
    this->DrawInTime(request);
    if (this->RayCounting)
    {
      this->CountRays(renderer);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::CountRays(vtkRenderer* renderer)
{
  Internals& internal = *this->Internal;
  const std::string fault =
    internal.Drawing.Count(renderer, internal.Scene, internal.ImageSampleDistance, internal.Counts);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Rays are not counted. " << fault);
  }
}

//------------------------------------------------------------------------------
// The clock decides on the number of rays of moving pictures, and on nothing else.
void vtkIlluminatedVolumeMapper::DrawInTime(const PictureRequest& request)
{
  Internals& internal = *this->Internal;
  internal.ImageSampleDistance = this->ImageSampleDistance;
  if (!request.Moving)
  {
    this->Draw(request.Renderer);
    return;
  }
  internal.ImageSampleDistance = std::max(internal.ImageSampleDistance,
    internal.Resolution.FindDistance(request.Volume->GetAllocatedRenderTime()));
  const int updates = this->GetNumberOfShadowUpdates();
  const double begin = vtkTimerLog::GetUniversalTime();
  this->Draw(request.Renderer);
  internal.Window->WaitForCompletion();
  // What is kept costs the same for any number of rays.
  const double kept =
    this->GetNumberOfShadowUpdates() > updates ? this->GetShadowUpdateSeconds() : 0.0;
  internal.Resolution.Measure(
    internal.ImageSampleDistance, vtkTimerLog::GetUniversalTime() - begin - kept);
}

//------------------------------------------------------------------------------
// What was loaded into one window's context is of no use in another's.
void vtkIlluminatedVolumeMapper::MoveTo(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLRenderWindow* before = this->Internal->Window;
  if (before && before != window)
  {
    before->MakeCurrent();
    this->ReleaseGraphicsResources(before);
  }
  this->Internal->Window = window;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Draw(vtkRenderer* renderer)
{
  Internals& internal = *this->Internal;
  const std::string fault =
    internal.Drawing.Draw(renderer, internal.Scene, internal.ImageSampleDistance);
  internal.ShadowsComplete = internal.Drawing.AreShadowsComplete();
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  vtkOpenGLRenderWindow* current = this->Internal->Window;
  if (current && current != window)
  {
    // Nothing of this mapper lives in that window.
    return;
  }
  this->Internal->Drawing.Release(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->Superclass::ReleaseGraphicsResources(window);
}
