#include "vtkIlluminatedVolumeMapper.h"

#include "DrawnScene.h"
#include "GradientNoise.h"
#include "InteractiveResolution.h"
#include "ShadowChoice.h"
#include "ShadowPreparation.h"
#include "TakenOver.h"
#include "VolumeDrawing.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeMaterial.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace penumbra;

namespace
{
// The camera's whole projection; VTK keeps its matrices transposed for OpenGL.
Matrix4 GetWorldToClip(vtkRenderer* renderer, vtkOpenGLCamera* camera)
{
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* viewToClip;
  vtkMatrix4x4* worldToClip;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  Matrix4 matrix;
  vtkMatrix4x4::Transpose(worldToClip->GetData(), matrix.data());
  return matrix;
}

//------------------------------------------------------------------------------
bool IsStepLength(double length)
{
  constexpr double longest = 1e30;
  return length > 0.0 && length < longest;
}
}

//------------------------------------------------------------------------------
class vtkIlluminatedVolumeMapper::Internals
{
public:
  DrawnScene Scene;
  VolumeDrawing Drawing;
  InteractiveResolution Resolution;
  double ImageSampleDistance = 1.0; ///< of the last frame
  bool AnythingVisible = true;
  std::string ShadowReason;
  int ShadowNearSteps = 0; ///< of the last frame
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
  return this->Internal->ShadowNearSteps;
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetShadowTechniqueReason() const
{
  return this->Internal->ShadowReason;
}

//------------------------------------------------------------------------------
std::size_t vtkIlluminatedVolumeMapper::GetShadowBytes() const
{
  const VolumeDrawing& drawing = this->Internal->Drawing;
  return drawing.GetVolumeOfShadows().GetBytes() + drawing.GetMapsOfShadows().GetBytes();
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
  const VolumeDrawing& drawing = this->Internal->Drawing;
  return drawing.GetVolumeOfShadows().GetNumberOfUpdates() +
    drawing.GetMapsOfShadows().GetNumberOfUpdates();
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetShadowUpdateSeconds() const
{
  const VolumeDrawing& drawing = this->Internal->Drawing;
  return drawing.GetVolumeOfShadows().GetBytes() > 0
    ? drawing.GetVolumeOfShadows().GetUpdateSeconds()
    : drawing.GetMapsOfShadows().GetUpdateSeconds();
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
  return this->Internal->Drawing.GetTextures().GetGradientReport().Bytes;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureLargestError() const
{
  return this->Internal->Drawing.GetTextures().GetGradientReport().LargestError;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetGradientTextureAngularError() const
{
  return this->Internal->Drawing.GetTextures().GetGradientReport().MeanAngularError;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfBricks() const
{
  return this->SkipEmptySpace ? this->Internal->Drawing.GetTextures().GetEmptySpaceReport().Bricks
                              : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfOccupiedBricks() const
{
  return this->SkipEmptySpace
    ? this->Internal->Drawing.GetTextures().GetEmptySpaceReport().OccupiedBricks
    : 0;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetBrickEdge() const
{
  return this->SkipEmptySpace
    ? this->Internal->Drawing.GetTextures().GetEmptySpaceReport().BrickEdge
    : 0;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetMeanVoxelDepth() const
{
  return this->Internal->Drawing.GetTextures().GetEmptySpaceReport().MeanExtinction *
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
// The stock ray caster does not end on a sample distance of 0, and VTK 9.1 keeps lights in arrays
// of six whose bound it does not check.
void vtkIlluminatedVolumeMapper::DrawStock(vtkRenderer* renderer, vtkVolume* volume)
{
  constexpr int largestNumberOfLights = 6;
  std::vector<vtkLight*> switchedOff;
  int lightsOn = 0;
  vtkCollectionSimpleIterator cursor;
  renderer->GetLights()->InitTraversal(cursor);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(cursor))
  {
    if (light->GetSwitch() && ++lightsOn > largestNumberOfLights)
    {
      light->SwitchOff();
      switchedOff.push_back(light);
    }
  }
  if (!switchedOff.empty())
  {
    this->Say("The stock ray caster takes six lights; the others are left out.");
  }
  // Adjusting, the stock ray caster takes another sample distance than the one that is asked.
  const auto askedToAdjust = this->AutoAdjustSampleDistances;
  this->AutoAdjustSampleDistances = 0;
  const float askedSampleDistance = this->SampleDistance;
  this->SampleDistance = static_cast<float>(this->GetSampleDistanceOrDefault());
  this->Superclass::GPURender(renderer, volume);
  this->SampleDistance = askedSampleDistance;
  this->AutoAdjustSampleDistances = askedToAdjust;
  for (vtkLight* light : switchedOff)
  {
    light->SwitchOn();
  }
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetSampleDistanceOrDefault()
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  if (IsStepLength(this->SampleDistance))
  {
    return this->SampleDistance;
  }
  if (!image)
  {
    return 1.0;
  }
  const double* spacing = image->GetSpacing();
  return 0.5 * std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetShadowSampleDistanceOrDefault()
{
  return IsStepLength(this->ShadowSampleDistance) ? this->ShadowSampleDistance
                                                  : 2.0 * this->GetSampleDistanceOrDefault();
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::DrawIlluminated(
  vtkRenderer* renderer, vtkVolume* volume, vtkDataArray* scalars)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  vtkOpenGLRenderWindow* window = this->Internal->Window;
  window->MakeCurrent();
  if (!this->PrepareGeometry(renderer, volume, image) ||
    !this->PrepareTextures(window, volume->GetProperty(), image, scalars))
  {
    return;
  }
  this->PrepareLights(renderer, volume->GetProperty());
  this->PrepareMaterial(window, volume->GetProperty());
  const ShadowSettings shadows = this->GetShadowSettings(renderer);
  for (const std::string& message :
    penumbra::PrepareShadows(shadows, window, this->Internal->Scene, this->Internal->Drawing))
  {
    this->Say(message);
  }
  this->PlanDraws();
  LookUpShadows(shadows, this->Internal->Scene);
  this->Internal->Scene.Matter = DescribeShadowingMatter(
    this->Internal->Scene, this->Internal->Drawing.GetTextures(), volume->GetProperty());
  if (this->Internal->AnythingVisible)
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
bool vtkIlluminatedVolumeMapper::PrepareGeometry(
  vtkRenderer* renderer, vtkVolume* volume, vtkImageData* image)
{
  DrawnScene& scene = this->Internal->Scene;
  if (!ComputeVolumePlacement(image, volume->GetMatrix(), scene.Placement))
  {
    vtkErrorMacro("The volume's spacing, direction or matrix has no inverse; it is not drawn.");
    return false;
  }
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  Vector3 eye;
  camera->GetPosition(eye.data());
  if (!ComputeViewRays(scene.Placement, GetWorldToClip(renderer, camera), eye, scene.Rays))
  {
    vtkErrorMacro("The camera's projection has no inverse; the volume is not drawn.");
    return false;
  }
  this->PrepareVisibility(image);
  return true;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrepareVisibility(vtkImageData* image)
{
  DrawnScene& scene = this->Internal->Scene;
  scene.ClippingPlanes.clear();
  const int planes = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  for (int plane = 0; plane < planes; ++plane)
  {
    scene.ClippingPlanes.push_back(scene.Placement.GetPlane(this->ClippingPlanes->GetItem(plane)));
  }
  scene.CroppingFlags = this->Cropping ? this->CroppingRegionFlags : 0;
  this->Internal->AnythingVisible = true;
  if (this->Cropping)
  {
    ComputeCroppingPlanes(image, this->CroppingRegionPlanes, scene.CroppingLow, scene.CroppingHigh);
  }
  if (scene.CroppingFlags == VTK_CROP_SUBVOLUME)
  {
    this->Internal->AnythingVisible =
      scene.Placement.CropBox(scene.CroppingLow, scene.CroppingHigh);
  }
}

//------------------------------------------------------------------------------
bool vtkIlluminatedVolumeMapper::PrepareTextures(vtkOpenGLRenderWindow* window,
  vtkVolumeProperty* property, vtkImageData* image, vtkDataArray* scalars)
{
  VolumeTextures& textures = this->Internal->Drawing.GetTextures();
  if (!textures.UpdateScalars(window, image, scalars))
  {
    const auto& dimensions = this->Internal->Scene.Placement.Dimensions;
    vtkErrorMacro("The graphics card cannot hold a volume of "
      << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2] << " voxels.");
    return false;
  }
  textures.SetInterpolation(property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION);
  if (textures.HasNonFiniteScalars())
  {
    this->Say(
      "Voxels that are NaN or -Inf count as the smallest finite value of the volume, +Inf as "
      "the largest.");
  }
  vtkImageData* mask = this->GetUsableMask(image);
  if (!textures.UpdateMask(window, mask))
  {
    vtkErrorMacro("The graphics card cannot hold the mask.");
    return false;
  }
  textures.UpdateTransferFunctions(
    window, property, static_cast<penumbra::GradientEstimator>(this->GradientEstimator));
  if (!textures.AreTransferFunctionsAccurate())
  {
    this->Say("The transfer functions change faster than the largest table can follow.");
  }
  this->Internal->Scene.UnitDistance = property->GetScalarOpacityUnitDistance(0);
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* vtkIlluminatedVolumeMapper::GetUsableMask(vtkImageData* image)
{
  vtkImageData* mask = this->MaskInput;
  if (!mask)
  {
    return nullptr;
  }
  const int* maskDimensions = mask->GetDimensions();
  if (!mask->GetPointData()->GetScalars() ||
    !std::equal(maskDimensions, maskDimensions + 3, image->GetDimensions()))
  {
    this->Say("The mask is left out: it needs scalars and the volume's dimensions.");
    return nullptr;
  }
  return mask;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrepareLights(vtkRenderer* renderer, vtkVolumeProperty* property)
{
  DrawnScene& scene = this->Internal->Scene;
  LightedScene lighted;
  lighted.Property = property;
  vtkNew<vtkLightCollection> lights;
  const int largestNumber = LightUniforms::GetLargestNumber(this->Internal->Window);
  const int left = CollectLights(renderer->GetLights(), property, largestNumber, lights);
  lighted.Lights = lights;
  lighted.TwoSidedLighting = renderer->GetTwoSidedLighting() != 0;
  lighted.ClippingPlanes = static_cast<int>(scene.ClippingPlanes.size());
  if (this->Cropping)
  {
    lighted.Cropping =
      scene.CroppingFlags == VTK_CROP_SUBVOLUME ? CroppingKind::Box : CroppingKind::Regions;
  }
  lighted.Mask = this->Internal->Drawing.GetTextures().HasMask();
  lighted.Opacity = this->Internal->Drawing.GetTextures().GetLookup();
  lighted.SteepOpacity = this->Internal->Drawing.GetTextures().AreTransferFunctionsSteep();
  lighted.LinearInterpolation = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  if (this->OpticalModel != ByShade)
  {
    lighted.Optics = static_cast<penumbra::OpticalModel>(this->OpticalModel - Absorption);
  }
  lighted.Gradient = static_cast<penumbra::GradientEstimator>(this->GradientEstimator);
  lighted.EnvironmentMap = this->PrepareEnvironment(this->Internal->Window, property);
  lighted.GradientTexture = this->GradientTextureBits > 0;
  lighted.EmptySpace = this->PrepareEmptySpace();
  scene.Requirements = ComputeLightingRequirements(lighted);
  if (left > 0 && scene.Requirements.IsShaded())
  {
    this->Say("The graphics card's shaders hold " + std::to_string(largestNumber) +
      " lights; the last " + std::to_string(left) + " give ambient light only.");
  }

  Vector3 cameraDirection;
  renderer->GetActiveCamera()->GetDirectionOfProjection(cameraDirection.data());
  scene.Lights = MakeLightUniforms(lights, property, scene.Placement, Normalized(cameraDirection));
  scene.Lights.SetAmbient(ComputeAmbientLight(renderer->GetLights()), property->GetAmbient(0));
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrepareMaterial(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property)
{
  DrawnScene& scene = this->Internal->Scene;
  scene.Material = MakeMaterialUniforms(property, scene.Placement);
  this->PrepareGradients(window);
  if (scene.Requirements.NoiseFading)
  {
    this->PrepareNoiseFading(property);
  }
}

//------------------------------------------------------------------------------
bool vtkIlluminatedVolumeMapper::PrepareEnvironment(
  vtkOpenGLRenderWindow* window, vtkVolumeProperty* property)
{
  const bool shaded = this->OpticalModel == SingleScattering ||
    (this->OpticalModel == ByShade && property->GetShade(0));
  if (!shaded || GetReflectionModel(property) != ReflectionModel::ReflectionMap)
  {
    return false;
  }
  std::string reason;
  const bool usable = this->Internal->Drawing.GetEnvironment().Update(
    window, vtkVolumeMaterial::SafeDownCast(property), reason);
  if (!usable)
  {
    this->Say("No environment map is reflected: " + reason + ".");
  }
  return usable;
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrepareGradients(vtkOpenGLRenderWindow* window)
{
  LightingRequirements& needs = this->Internal->Scene.Requirements;
  const int bits = needs.GradientTexture ? this->GradientTextureBits : 0;
  if (!this->Internal->Drawing.GetTextures().UpdateGradients(window, needs.Gradient, bits))
  {
    needs.GradientTexture = false;
    this->Say("The graphics card cannot hold the gradients; they are estimated at each sample.");
  }
}

//------------------------------------------------------------------------------
// Whether there is enough of it to leap over.
bool vtkIlluminatedVolumeMapper::PrepareEmptySpace()
{
  VolumeTextures& textures = this->Internal->Drawing.GetTextures();
  if (!this->SkipEmptySpace && this->ShadowTechnique != Auto)
  {
    textures.DropEmptySpace(this->Internal->Window);
    return false;
  }
  const DrawnScene& scene = this->Internal->Scene;
  CroppedRegions regions;
  regions.On = this->Cropping && scene.CroppingFlags != VTK_CROP_SUBVOLUME;
  if (regions.On)
  {
    regions.Flags = scene.CroppingFlags;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double voxels = scene.Placement.Dimensions[axis];
      regions.Low[axis] = scene.CroppingLow[axis] * voxels - 0.5;
      regions.High[axis] = scene.CroppingHigh[axis] * voxels - 0.5;
    }
  }
  return textures.UpdateEmptySpace(this->Internal->Window, regions) && this->SkipEmptySpace;
}

//------------------------------------------------------------------------------
// Differences per voxel have the noise of their estimator along each axis, and so the gradient, a
// linear map of them, has that times the map's Frobenius norm.
void vtkIlluminatedVolumeMapper::PrepareNoiseFading(vtkVolumeProperty* property)
{
  DrawnScene& scene = this->Internal->Scene;
  VolumeTextures& textures = this->Internal->Drawing.GetTextures();
  Matrix3 map = scene.Placement.GetGradientToMagnitude();
  double squares = 0.0;
  for (const double element : map)
  {
    squares += element * element;
  }
  const double fading = vtkVolumeMaterial::SafeDownCast(property)->GetNoiseFading();
  const double noise = GradientNoise(textures.GetNoise(), scene.Requirements.Gradient);
  constexpr double largest = 1e30;
  const double factor =
    std::min(textures.GetScalarUnit() / (fading * noise * std::sqrt(squares)), largest);
  for (double& element : map)
  {
    element *= factor;
  }
  scene.Material.GradientToNoise = map;
  scene.Material.FadedReflection = scene.Requirements.TwoSidedLighting ? 0.5 : 0.25;
}

//------------------------------------------------------------------------------
ShadowSettings vtkIlluminatedVolumeMapper::GetShadowSettings(vtkRenderer* renderer)
{
  ShadowSettings settings;
  settings.Resolution = this->ShadowResolution;
  settings.NearSteps = this->ShadowNearSteps;
  this->Internal->ShadowReason = "as asked";
  if (!this->Internal->AnythingVisible)
  {
    this->Internal->ShadowReason = "nothing is visible";
  }
  else if (this->ShadowTechnique == Auto)
  {
    const ShadowChoice choice = this->ChooseShadows(renderer);
    settings.Technique = choice.Technique;
    settings.Resolution *= choice.Resolution;
    settings.NearSteps = choice.NearSteps;
    this->Internal->ShadowReason = choice.Reason;
  }
  else
  {
    settings.Technique = static_cast<penumbra::ShadowTechnique>(this->ShadowTechnique - Rays);
  }
  settings.MemoryLimit = this->ShadowMemoryLimit;
  this->Internal->ShadowNearSteps = settings.NearSteps;
  return settings;
}

//------------------------------------------------------------------------------
ShadowChoice vtkIlluminatedVolumeMapper::ChooseShadows(vtkRenderer* renderer)
{
  const DrawnScene& scene = this->Internal->Scene;
  const VolumePlacement& placement = scene.Placement;
  const VolumeTextures& textures = this->Internal->Drawing.GetTextures();
  ShadowChoiceTask task;
  task.SoftLights = scene.Requirements.GetNumberOfLights(ShadowKind::Soft);
  task.HardLights = scene.Requirements.GetNumberOfLights(ShadowKind::Hard);
  // Whether rays leap over it or not: that must not change the choice.
  const EmptySpaceReport& matter = textures.GetEmptySpaceReport();
  task.VoxelDepth = matter.MeanExtinction * placement.SmallestSpacing;
  task.Occupied = 1.0 * matter.OccupiedBricks / std::max(matter.Bricks, 1);
  task.ShadowStep = this->GetShadowSampleDistanceOrDefault() / placement.SmallestSpacing;
  task.SpacingRatio = placement.LargestSpacing / placement.SmallestSpacing;
  task.SteepOpacity = scene.Requirements.PreIntegrated;
  const int* size = renderer->GetSize();
  task.Pixels = 1.0 * size[0] * size[1];
  task.VoxelsAcross = placement.GetDiagonal() / placement.SmallestSpacing;
  task.Voxels = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    task.Voxels *=
      1.0 + (placement.BoxHigh[axis] - placement.BoxLow[axis]) * placement.Dimensions[axis];
  }
  task.Tolerance = this->ShadowTolerance;
  return ChooseShadowTechnique(task);
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PlanDraws()
{
  DrawnScene& scene = this->Internal->Scene;
  MarchingTask task;
  task.Diagonal = scene.Placement.GetDiagonal();
  task.SampleDistance = this->GetSampleDistanceOrDefault();
  task.ShadowSampleDistance = this->GetShadowSampleDistanceOrDefault();
  if (!scene.ShadowCasters.empty())
  {
    // What is kept is marched once: with half the step, interpolation is all the error there is.
    task.ShadowSampleDistance *= 0.5;
  }
  task.Lights = scene.Requirements.GetNumberOfLights();
  task.LookedUpShadows = static_cast<int>(scene.ShadowCasters.size());
  task.ShadowMaps = scene.MapsOfShadows.Lights > 0;
  task.ShadowNearSteps = this->Internal->ShadowNearSteps;
  task.ShadowedLights = scene.Requirements.GetNumberOfShadowedLights() - task.LookedUpShadows;
  task.LookupIterations = scene.Requirements.Opacity == TransferFunctionLookup::Points
    ? this->Internal->Drawing.GetTextures().GetLookupIterations()
    : 0;
  task.ClippingPlanes = scene.Requirements.ClippingPlanes;
  scene.Plan = PlanMarching(task);
  if (scene.Plan.Coarsened)
  {
    this->Say("Steps are longer than asked: rays would have more of them than can be drawn.");
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Draw(vtkRenderer* renderer)
{
  Internals& internal = *this->Internal;
  switch (internal.Drawing.Draw(renderer, internal.Scene, internal.ImageSampleDistance))
  {
    case VolumeDrawing::Result::NoProgram:
      vtkErrorMacro("The volume is not drawn: its shader program could not be built.");
      break;
    case VolumeDrawing::Result::NoFloatFramebuffer:
      vtkErrorMacro("The volume is not drawn: the picture is made in parts, which needs a float "
                    "framebuffer that the graphics card does not have.");
      break;
    case VolumeDrawing::Result::Drawn:
      break;
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
  os << indent << "ShadowTechnique: " << techniques[this->ShadowTechnique] << "\n";
  os << indent << "ShadowTolerance: " << this->ShadowTolerance << "\n";
  os << indent << "ShadowResolution: " << this->ShadowResolution << "\n";
  os << indent << "ShadowNearSteps: " << this->ShadowNearSteps << "\n";
  os << indent << "ShadowMemoryLimit: " << this->ShadowMemoryLimit << "\n";
  os << indent << "ShadowBytes: " << this->GetShadowBytes() << "\n";
  os << indent << "ShadowSampleDistance: " << this->ShadowSampleDistance << "\n";
  os << indent << "GradientEstimator: " << this->GradientEstimator << "\n";
  os << indent << "GradientTextureBits: " << this->GradientTextureBits << "\n";
  os << indent << "GradientTextureBytes: " << this->GetGradientTextureBytes() << "\n";
  os << indent << "SkipEmptySpace: " << this->SkipEmptySpace << "\n";
  os << indent << "NumberOfBricks: " << this->GetNumberOfBricks() << "\n";
  os << indent << "NumberOfOccupiedBricks: " << this->GetNumberOfOccupiedBricks() << "\n";
  os << indent << "OpticalModel: " << this->OpticalModel << "\n";
  os << indent << "ActualSampleDistance: " << this->GetActualSampleDistance() << "\n";
  os << indent << "ActualShadowSampleDistance: " << this->GetActualShadowSampleDistance() << "\n";
  os << indent << "ActualImageSampleDistance: " << this->GetActualImageSampleDistance() << "\n";
  os << indent << "NumberOfDraws: " << this->GetNumberOfDraws() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
}
