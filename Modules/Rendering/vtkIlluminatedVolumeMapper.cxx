#include "vtkIlluminatedVolumeMapper.h"

#include "AccumulationBuffer.h"
#include "IlluminationPass.h"
#include "LightUniforms.h"
#include "MarchingPlan.h"
#include "StandInBox.h"
#include "TakenOver.h"
#include "VolumeGeometry.h"
#include "VolumeTextures.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace penumbra;

namespace
{
std::array<float, 9> ToColumns(const Matrix3& matrix)
{
  std::array<float, 9> columns;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      columns[3 * column + row] = static_cast<float>(matrix[3 * row + column]);
    }
  }
  return columns;
}

std::array<float, 16> ToColumns(const Matrix4& matrix)
{
  std::array<float, 16> columns;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      columns[4 * column + row] = static_cast<float>(matrix[4 * row + column]);
    }
  }
  return columns;
}

Matrix3 GetLinearPart(const Matrix4& m)
{
  return { m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10] };
}

void SetMatrix(vtkShaderProgram* program, const char* name, const Matrix3& matrix)
{
  if (program->IsUniformUsed(name))
  {
    auto columns = ToColumns(matrix);
    program->SetUniformMatrix3x3(name, columns.data());
  }
}

void SetVector(vtkShaderProgram* program, const char* name, const Vector3& vector)
{
  program->SetUniform3f(name, vector.data());
}

void SetVector(vtkShaderProgram* program, const char* name, const std::array<double, 4>& vector)
{
  const float values[4] = { static_cast<float>(vector[0]), static_cast<float>(vector[1]),
    static_cast<float>(vector[2]), static_cast<float>(vector[3]) };
  program->SetUniform4f(name, values);
}

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
}

//------------------------------------------------------------------------------
// All that belongs to the drawing itself: what the scene looks like to the shader, the textures and the
// program. The mapper collects it, the render pass hands it to the program.
class vtkIlluminatedVolumeMapper::Internals
{
public:
  struct Picture
  {
    int Width = 1; ///< pixels that are drawn
    int Height = 1;
    int X = 0;     ///< of the viewport in the framebuffer that is drawn to
    int Y = 0;
    int FirstStep = 0;
    int LastStep = 0;
  };

  Internals()
  {
    this->Pass->SetUniforms = [this](vtkShaderProgram* program) { this->SetUniforms(program); };
  }

  void SetUniforms(vtkShaderProgram* program);
  void SetRayUniforms(vtkShaderProgram* program);
  void SetCroppingUniforms(vtkShaderProgram* program);
  void Release(vtkOpenGLRenderWindow* window);

  vtkNew<vtkIlluminationPass> Pass;
  StandInBox Box;
  VolumeTextures Textures;
  AccumulationBuffer Accumulation;

  VolumeGeometry Geometry;
  ViewRays Rays;
  LightingRequirements Requirements;
  LightUniforms Lights;
  std::vector<std::array<double, 4>> ClippingPlanes;
  Vector3 CroppingLow{};
  Vector3 CroppingHigh{};
  int CroppingFlags = 0;
  double UnitDistance = 1.0;
  MarchingPlan Plan;
  Picture Current;
  bool Gathering = false;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  std::vector<std::string> Messages;
  std::set<std::string> MessagesGiven;
};

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Internals::SetRayUniforms(vtkShaderProgram* program)
{
  const float origin[2] = { static_cast<float>(this->Current.X),
    static_cast<float>(this->Current.Y) };
  const float scale[2] = { 2.0f / static_cast<float>(this->Current.Width),
    2.0f / static_cast<float>(this->Current.Height) };
  program->SetUniform2f("scene_viewportOrigin", origin);
  program->SetUniform2f("scene_viewportScale", scale);
  SetMatrix(program, "scene_rayBase", this->Rays.Base);
  SetMatrix(program, "scene_rayDirection", this->Rays.Direction);
  program->SetUniformf("scene_rayEye", static_cast<float>(this->Rays.EyeParameter));
  SetVector(program, "scene_clipDepth", this->Rays.ClipDepth);
  SetVector(program, "scene_clipW", this->Rays.ClipW);
  auto boxToClip = ToColumns(this->Box.GetBoxToClip(this->Rays.TextureToClip));
  program->SetUniformMatrix4x4("scene_boxToClip", boxToClip.data());
  program->SetUniformi("scene_firstStep", this->Current.FirstStep);
  program->SetUniformi("scene_lastStep", this->Current.LastStep);
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Internals::SetCroppingUniforms(vtkShaderProgram* program)
{
  SetVector(program, "scene_boxLow", this->Geometry.BoxLow);
  SetVector(program, "scene_boxHigh", this->Geometry.BoxHigh);
  if (program->IsUniformUsed("scene_croppingFlags"))
  {
    SetVector(program, "scene_croppingLow", this->CroppingLow);
    SetVector(program, "scene_croppingHigh", this->CroppingHigh);
    program->SetUniformi("scene_croppingFlags", this->CroppingFlags);
  }
  if (!this->ClippingPlanes.empty())
  {
    std::vector<std::array<float, 4>> planes;
    for (const auto& plane : this->ClippingPlanes)
    {
      planes.push_back({ static_cast<float>(plane[0]), static_cast<float>(plane[1]),
        static_cast<float>(plane[2]), static_cast<float>(plane[3]) });
    }
    program->SetUniform4fv(
      "scene_clippingPlanes", static_cast<int>(planes.size()), planes.front().data());
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Internals::SetUniforms(vtkShaderProgram* program)
{
  Vector3 voxel;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int count = this->Geometry.Dimensions[axis];
    voxel[axis] = count > 1 ? 1.0 / count : 0.0;
  }
  SetVector(program, "scene_voxel", voxel);
  SetMatrix(program, "scene_textureToOwn", GetLinearPart(this->Geometry.TextureToOwn));
  SetMatrix(program, "scene_textureToWorld", GetLinearPart(this->Geometry.TextureToWorld));
  SetMatrix(program, "scene_gradientToWorld", this->Geometry.GetGradientToWorld());
  program->SetUniformf("scene_sampleDistance", static_cast<float>(this->Plan.SampleDistance));
  program->SetUniformf(
    "scene_shadowSampleDistance", static_cast<float>(this->Plan.ShadowSampleDistance));
  this->SetRayUniforms(program);
  this->SetCroppingUniforms(program);
  this->Textures.SetUniforms(program, this->Geometry, this->UnitDistance);
  this->Lights.Set(program);
  if (this->Gathering)
  {
    program->SetUniformi("scene_accumulated", this->Accumulation.GetPreviousTextureUnit());
    AccumulationBuffer::ReplaceInsteadOfBlending(this->Window);
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Internals::Release(vtkOpenGLRenderWindow* window)
{
  this->Box.Release(window);
  this->Textures.Release(window);
  this->Accumulation.Release(window);
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkIlluminatedVolumeMapper);

//------------------------------------------------------------------------------
vtkIlluminatedVolumeMapper::vtkIlluminatedVolumeMapper()
  : Internal(std::make_unique<Internals>())
{
  this->AutoAdjustSampleDistances = 0;
  this->SampleDistance = 0.0f;
}

//------------------------------------------------------------------------------
vtkIlluminatedVolumeMapper::~vtkIlluminatedVolumeMapper() = default;

//------------------------------------------------------------------------------
const LightingRequirements& vtkIlluminatedVolumeMapper::GetRequirements() const
{
  return this->Internal->Requirements;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualSampleDistance() const
{
  return this->Internal->Plan.SampleDistance;
}

//------------------------------------------------------------------------------
double vtkIlluminatedVolumeMapper::GetActualShadowSampleDistance() const
{
  return this->Internal->Plan.ShadowSampleDistance;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfDraws() const
{
  return this->Internal->Plan.Draws;
}

//------------------------------------------------------------------------------
int vtkIlluminatedVolumeMapper::GetNumberOfShaderBuilds() const
{
  return this->Internal->Pass->GetNumberOfBuilds();
}

//------------------------------------------------------------------------------
const std::string& vtkIlluminatedVolumeMapper::GetFragmentShaderSource() const
{
  return this->Internal->Pass->GetFragmentSource();
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
    this->Say(notTakenOver + " is drawn by the stock ray caster, without Penumbra's light and shadow.");
  }
  this->DrawStock(renderer, volume);
}

//------------------------------------------------------------------------------
// VTK 9.1 keeps lights in arrays of six and does not check their number.
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
  this->Superclass::GPURender(renderer, volume);
  for (vtkLight* light : switchedOff)
  {
    light->SwitchOn();
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::DrawIlluminated(
  vtkRenderer* renderer, vtkVolume* volume, vtkDataArray* scalars)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  auto* image = vtkImageData::SafeDownCast(this->GetDataSetInput());
  this->MoveTo(window);
  window->MakeCurrent();
  if (!this->PrepareGeometry(renderer, volume, image) ||
    !this->PrepareTextures(window, volume->GetProperty(), image, scalars))
  {
    return;
  }
  this->PrepareLights(renderer, volume->GetProperty());
  this->Draw(renderer);
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
  Internals& internal = *this->Internal;
  if (!ComputeVolumeGeometry(image, volume->GetMatrix(), internal.Geometry))
  {
    vtkErrorMacro("The volume's spacing, direction or matrix has no inverse; it is not drawn.");
    return false;
  }
  internal.CroppingFlags = 0;
  if (this->Cropping)
  {
    ComputeCroppingPlanes(
      image, this->CroppingRegionPlanes, internal.CroppingLow, internal.CroppingHigh);
    internal.CroppingFlags = this->CroppingRegionFlags;
  }
  if (this->Cropping && this->CroppingRegionFlags == VTK_CROP_SUBVOLUME)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double& low = internal.Geometry.BoxLow[axis];
      double& high = internal.Geometry.BoxHigh[axis];
      low = std::max(low, internal.CroppingLow[axis]);
      high = std::min(high, internal.CroppingHigh[axis]);
      if (low >= high)
      {
        return false;
      }
    }
  }
  internal.ClippingPlanes.clear();
  const int planes = this->ClippingPlanes ? this->ClippingPlanes->GetNumberOfItems() : 0;
  for (int plane = 0; plane < planes; ++plane)
  {
    internal.ClippingPlanes.push_back(
      internal.Geometry.GetPlane(this->ClippingPlanes->GetItem(plane)));
  }
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  Vector3 eye;
  camera->GetPosition(eye.data());
  if (!ComputeViewRays(internal.Geometry, GetWorldToClip(renderer, camera), eye, internal.Rays))
  {
    vtkErrorMacro("The camera's projection has no inverse; the volume is not drawn.");
    return false;
  }
  internal.Box.Place(internal.Geometry);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIlluminatedVolumeMapper::PrepareTextures(vtkOpenGLRenderWindow* window,
  vtkVolumeProperty* property, vtkImageData* image, vtkDataArray* scalars)
{
  VolumeTextures& textures = this->Internal->Textures;
  if (!textures.UpdateScalars(window, image, scalars))
  {
    const auto& dimensions = this->Internal->Geometry.Dimensions;
    vtkErrorMacro("The graphics card cannot hold a volume of "
      << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2] << " voxels.");
    return false;
  }
  textures.SetInterpolation(property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION);
  if (textures.HasNonFiniteScalars())
  {
    this->Say("Voxels that are NaN or -Inf count as the smallest finite value of the volume, +Inf as "
              "the largest.");
  }
  vtkImageData* mask = this->GetUsableMask(image);
  if (!textures.UpdateMask(window, mask))
  {
    vtkErrorMacro("The graphics card cannot hold the mask.");
    return false;
  }
  textures.UpdateTransferFunctions(window, property);
  this->Internal->UnitDistance = property->GetScalarOpacityUnitDistance(0);
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
  Internals& internal = *this->Internal;
  LightedScene scene;
  scene.Property = property;
  scene.Lights = renderer->GetLights();
  scene.TwoSidedLighting = renderer->GetTwoSidedLighting() != 0;
  scene.ClippingPlanes = static_cast<int>(internal.ClippingPlanes.size());
  if (this->Cropping)
  {
    scene.Cropping = this->CroppingRegionFlags == VTK_CROP_SUBVOLUME ? CroppingKind::Box
                                                                    : CroppingKind::Regions;
  }
  scene.Mask = internal.Textures.HasMask();
  scene.Opacity = internal.Textures.GetLookup();
  internal.Requirements = ComputeLightingRequirements(scene);

  Vector3 cameraDirection;
  renderer->GetActiveCamera()->GetDirectionOfProjection(cameraDirection.data());
  internal.Lights =
    MakeLightUniforms(scene.Lights, property, internal.Geometry, Normalized(cameraDirection));

  MarchingTask task;
  task.Diagonal = internal.Geometry.GetDiagonal();
  task.SampleDistance =
    this->SampleDistance > 0.0f ? this->SampleDistance : 0.5 * internal.Geometry.SmallestSpacing;
  task.ShadowSampleDistance =
    this->ShadowSampleDistance > 0.0 ? this->ShadowSampleDistance : 2.0 * task.SampleDistance;
  task.Lights = internal.Requirements.GetNumberOfLights();
  task.ShadowedLights = internal.Requirements.GetNumberOfShadowedLights();
  task.LookupIterations = internal.Textures.GetLookupIterations();
  task.ClippingPlanes = scene.ClippingPlanes;
  internal.Plan = PlanMarching(task);
  if (internal.Plan.Coarsened)
  {
    this->Say("Steps are longer than asked: the rays would have more than single precision can place.");
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::Draw(vtkRenderer* renderer)
{
  Internals& internal = *this->Internal;
  AccumulationBuffer::Viewport viewport;
  renderer->GetTiledSizeAndOrigin(&viewport.Width, &viewport.Height, &viewport.X, &viewport.Y);
  internal.Gathering = internal.Plan.Draws > 1 || this->ImageSampleDistance != 1.0f;
  internal.Pass->Select(internal.Requirements, internal.Gathering);
  internal.Pass->ExpectDraw();
  internal.Textures.Activate();
  if (internal.Gathering)
  {
    const auto reduced = [this](int pixels) {
      return std::max(1, static_cast<int>(std::lround(pixels / this->ImageSampleDistance)));
    };
    const int width = reduced(viewport.Width);
    const int height = reduced(viewport.Height);
    const bool gathered = internal.Accumulation.Gather(
      internal.Window, viewport, width, height, internal.Plan.Draws, [&](int draw) {
        const int first = draw * internal.Plan.StepsPerDraw;
        internal.Current = { width, height, 0, 0, first, first + internal.Plan.StepsPerDraw };
        internal.Box.Draw(renderer, internal.Pass);
      });
    if (!gathered)
    {
      vtkErrorMacro("The graphics card has no float framebuffer, which a picture in parts needs.");
    }
  }
  else
  {
    internal.Current = { viewport.Width, viewport.Height, viewport.X, viewport.Y, 0,
      internal.Plan.Steps };
    internal.Box.Draw(renderer, internal.Pass);
  }
  internal.Textures.Deactivate();
  if (internal.Pass->GetProgramFailed())
  {
    vtkErrorMacro("The volume is not drawn: its shader program could not be built.");
  }
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkIlluminatedVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadowTechnique: " << (this->ShadowTechnique == Rays ? "Rays" : "Auto") << "\n";
  os << indent << "ShadowSampleDistance: " << this->ShadowSampleDistance << "\n";
  os << indent << "ActualSampleDistance: " << this->GetActualSampleDistance() << "\n";
  os << indent << "ActualShadowSampleDistance: " << this->GetActualShadowSampleDistance() << "\n";
  os << indent << "NumberOfDraws: " << this->GetNumberOfDraws() << "\n";
  os << indent << "NumberOfShaderBuilds: " << this->GetNumberOfShaderBuilds() << "\n";
}
