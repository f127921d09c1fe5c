#include "vtkIlluminatedVolumeMapper.h"

#include "DrawnScene.h"
#include "InteractiveResolution.h"
#include "PicturePreparation.h"
#include "PictureRequest.h"
#include "ShadowSettings.h"
#include "StepPreparation.h"
#include "StockLights.h"
#include "TakenOver.h"
#include "VolumeDrawing.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <set>

using namespace penumbra;

//------------------------------------------------------------------------------
class vtkIlluminatedVolumeMapper::Internals
{
public:
  const EmptySpaceReport& GetEmptySpace() const
  {
    return this->Drawing.GetTextures().GetEmptySpaceReport();
  }
  const GradientTextureReport& GetGradients() const
  {
    return this->Drawing.GetTextures().GetGradientReport();
  }

  DrawnScene Scene;
  ShadowSettings Shadows;
  VolumeDrawing Drawing;
  InteractiveResolution Resolution;
  double ImageSampleDistance = 1.0; ///< of the last frame
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::vector<std::string> Messages;
  std::set<std::string> MessagesGiven;
};

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
const LightingRequirements& vtkIlluminatedVolumeMapper::GetRequirements() const
{
  return this->Internal->Scene.Requirements;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualSampleDistance() const
{
  return this->Internal->Scene.Plan.SampleDistance;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualShadowSampleDistance() const
{
  return this->Internal->Scene.Plan.ShadowSampleDistance;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualImageSampleDistance() const
{
  return this->Internal->ImageSampleDistance;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetActualShadowNearSteps() const
{
  return this->Internal->Shadows.NearSteps;
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetShadowTechniqueReason() const
{
  return this->Internal->Shadows.Reason;
}

//------------------------------------------------------------------------------
std::size_t vtkIlluminatedVolumeMapper::GetShadowBytes() const
{
  return this->Internal->Drawing.GetShadowReport().Bytes;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualShadowResolution() const
{
  const DrawnScene& scene = this->Internal->Scene;
  return std::max(scene.VolumeOfShadows.Resolution, scene.MapsOfShadows.Resolution);
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfShadowUpdates() const
{
  return this->Internal->Drawing.GetShadowReport().Updates;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetShadowUpdateSeconds() const
{
  return this->Internal->Drawing.GetShadowReport().UpdateSeconds;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfDraws() const
{
  return this->Internal->Scene.Plan.Draws;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfShaderBuilds() const
{
  return this->Internal->Drawing.GetPass()->GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::SetGradientTextureBits(int bits)
{
  const int allowed = bits <= 0 ? 0 : bits <= 8 ? 8 : 16;
  if (allowed != this->GradientTextureBits)
  {
    this->GradientTextureBits = allowed;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::size_t vtkIlluminatedVolumeMapper::GetGradientTextureBytes() const
{
  return this->Internal->GetGradients().Bytes;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureLargestError() const
{
  return this->Internal->GetGradients().LargestError;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureAngularError() const
{
  return this->Internal->GetGradients().MeanAngularError;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfBricks() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().Bricks : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfOccupiedBricks() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().OccupiedBricks : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetBrickEdge() const
{
  return this->SkipEmptySpace ? this->Internal->GetEmptySpace().BrickEdge : 0;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetMeanVoxelDepth() const
{
  return this->Internal->GetEmptySpace().MeanExtinction *
    this->Internal->Scene.Placement.SmallestSpacing;
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetFragmentShaderSource() const
{
  return this->Internal->Drawing.GetPass()->GetFragmentSource();
}

//------------------------------------------------------------------------------
const std::vector<std::string>& vtkIlluminatedVolumeMapper::GetMessages() const
{
  return this->Internal->Messages;
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
  std::vector<std::string> messages;
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
    this->DrawInTime(renderer, volume->GetAllocatedRenderTime());
  }
}

//------------------------------------------------------------------------------
// The clock decides on the number of rays of moving pictures, and on nothing else.
void vtkIlluminatedVolumeMapper::DrawInTime(vtkRenderer* renderer, double allocatedSeconds)
{
  Internals& internal = *this->Internal;
  internal.ImageSampleDistance = this->ImageSampleDistance;
  if (!this->AutoAdjustSampleDistances || !InteractiveResolution::IsInteractive(allocatedSeconds))
  {
    this->Draw(renderer);
    return;
  }
  internal.ImageSampleDistance =
    std::max(internal.ImageSampleDistance, internal.Resolution.FindDistance(allocatedSeconds));
  const int updates = this->GetNumberOfShadowUpdates();
  const double begin = vtkTimerLog::GetUniversalTime();
  this->Draw(renderer);
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

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const techniques[] = { "Auto", "Rays", "Volume", "Map", "DeepMap" };
  static const char* const estimators[] = { "CentralDifferences", "ForwardDifferences",
    "BackwardDifferences", "Sobel" };
  static const char* const models[] = { "ByShade", "Absorption", "Emission", "AbsorptionEmission",
    "SingleScattering" };
  const auto print = [&](const char* name, const auto& value)
  { os << indent << name << ": " << value << "\n"; };
  print("ShadowTechnique", techniques[this->ShadowTechnique]);
  print("ShadowTolerance", this->ShadowTolerance);
  print("ShadowResolution", this->ShadowResolution);
  print("ShadowNearSteps", this->ShadowNearSteps);
  print("ShadowMemoryLimit", this->ShadowMemoryLimit);
  print("ShadowSampleDistance", this->ShadowSampleDistance);
  print("GradientEstimator", estimators[this->GradientEstimator]);
  print("GradientTextureBits", this->GradientTextureBits);
  print("SkipEmptySpace", this->SkipEmptySpace ? "On" : "Off");
  print("OpticalModel", models[this->OpticalModel]);
  print("ShadowTechniqueReason", this->GetShadowTechniqueReason());
  print("ShadowBytes", this->GetShadowBytes());
  print("ActualShadowResolution", this->GetActualShadowResolution());
  print("ActualShadowNearSteps", this->GetActualShadowNearSteps());
  print("NumberOfShadowUpdates", this->GetNumberOfShadowUpdates());
  print("ShadowUpdateSeconds", this->GetShadowUpdateSeconds());
  print("GradientTextureBytes", this->GetGradientTextureBytes());
  print("GradientTextureLargestError", this->GetGradientTextureLargestError());
  print("GradientTextureAngularError", this->GetGradientTextureAngularError());
  print("NumberOfBricks", this->GetNumberOfBricks());
  print("NumberOfOccupiedBricks", this->GetNumberOfOccupiedBricks());
  print("BrickEdge", this->GetBrickEdge());
  print("MeanVoxelDepth", this->GetMeanVoxelDepth());
  print("ActualSampleDistance", this->GetActualSampleDistance());
  print("ActualShadowSampleDistance", this->GetActualShadowSampleDistance());
  print("ActualImageSampleDistance", this->GetActualImageSampleDistance());
  print("NumberOfDraws", this->GetNumberOfDraws());
  print("NumberOfShaderBuilds", this->GetNumberOfShaderBuilds());
  print("NumberOfMessages", this->GetMessages().size());
}
