#include "VolumeView.h"

#include "Picture.h"
#include "SceneCamera.h"
#include "SceneDocument.h"
#include "SceneRendering.h"
#include "SurfacePicking.h"
#include "ViewDecorations.h"
#include "ViewOverlay.h"
#include "VolumeFields.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <chrono>

namespace penumbra
{
namespace
{
// Frames a second while something moves.
constexpr double FluidRate = 10.0;
// Of a volume that was not drawn yet, whose first picture is to be there soon.
constexpr double AssumedSecondsOfFrame = 2.0;
// Nothing moves when it has not for so long.
constexpr int StillMilliseconds = 250;
// Whole frames that take longer than this many seconds come only after a longer pause, and before
// them quick ones.
constexpr double LongestFrame = 3.0;
constexpr double LongestQuickFrame = 1.0;
constexpr int LongStillMilliseconds = 1000;
constexpr double KeyDegrees = 5.0;
constexpr double KeyZoom = 1.1;

void Zoom(vtkCamera* camera, double factor)
{
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }
  else
  {
    camera->Dolly(factor);
  }
}
}

//------------------------------------------------------------------------------
VolumeView::VolumeView(SceneDocument* document, QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Document(document)
{
  this->setObjectName("volumeView");
  this->setAccessibleName(tr("3D view"));
  this->setAccessibleDescription(tr("The volume with its lights and shadows"));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumSize(160, 120);
  this->Window->SetMultiSamples(0);
  this->setRenderWindow(this->Window);

  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->interactor()->SetInteractorStyle(style);
  this->interactor()->SetDesiredUpdateRate(FluidRate);
  // The interactor asks for frames; when and how they are drawn is decided here.
  this->interactor()->EnableRenderOff();
  this->interactor()->AddObserver(vtkCommand::RenderEvent, this, &VolumeView::ScheduleFrame);

  this->Decorations = std::make_unique<ViewDecorations>(this->interactor());
  this->Overlay = std::make_unique<ViewOverlay>(this->Window);
  this->FrameTimer.setSingleShot(true);
  this->RefineTimer.setSingleShot(true);
  this->connect(&this->FrameTimer, &QTimer::timeout, this, &VolumeView::DrawMoving);
  this->connect(&this->RefineTimer, &QTimer::timeout, this, &VolumeView::Refine);
  this->connect(document, &SceneDocument::opened, this, &VolumeView::ShowOpened);
  this->connect(document, &SceneDocument::changed, this, &VolumeView::ShowChanged);
}

//------------------------------------------------------------------------------
VolumeView::~VolumeView()
{
  this->Forget();
  this->Decorations.reset();
  this->Window->RemoveRenderer(this->Overlay->GetRenderer());
}

//------------------------------------------------------------------------------
void VolumeView::Forget()
{
  this->makeCurrent();
  if (this->Rendering)
  {
    this->Decorations->Detach();
    this->Overlay->Attach(nullptr);
    // The style keeps the renderer that it moved last.
    this->interactor()->GetInteractorStyle()->SetCurrentRenderer(nullptr);
    this->Window->RemoveRenderer(this->Rendering->GetRenderer());
    this->Rendering.reset();
  }
}

//------------------------------------------------------------------------------
void VolumeView::ShowOpened()
{
  this->Forget();
  const SceneDescription& scene = this->Document->GetScene();
  this->Rendering = std::make_unique<SceneRendering>(scene, this->Document->GetVoxels());
  this->Renderer = scene.Renderer;
  this->Window->AddRenderer(this->Rendering->GetRenderer());
  this->AttachDecorations();
  this->Quality.NoteFrame(AssumedSecondsOfFrame, 1);
  this->SecondsOfLastWholeFrame = 0.0;
}

//------------------------------------------------------------------------------
void VolumeView::AttachDecorations()
{
  vtkImageData* volume = this->Document->GetVoxels().Volume;
  // Of what the readers tell, only DICOM's world is known to be a patient's.
  const bool isPatient = !TextField(volume, "Modality").empty();
  this->Decorations->Attach(this->Rendering->GetRenderer(), isPatient, isPatient ? "mm" : "");
  this->Overlay->Attach(this->Rendering->GetRenderer());
}

//------------------------------------------------------------------------------
void VolumeView::ShowChanged()
{
  const SceneDescription& scene = this->Document->GetScene();
  if (scene.Renderer != this->Renderer)
  {
    const CameraDescription camera = this->GetCamera();
    this->ShowOpened();
    ApplyCamera(camera, this->Rendering->GetRenderer()->GetActiveCamera());
  }
  else
  {
    this->Rendering->Update(scene, this->Document->GetVoxels().Environment);
  }
  this->SceneChanged = true;
  this->ScheduleFrame();
}

//------------------------------------------------------------------------------
CameraDescription VolumeView::GetCamera() const
{
  vtkCamera* camera = this->Rendering->GetRenderer()->GetActiveCamera();
  CameraDescription description;
  camera->GetPosition(description.Position.emplace().data());
  camera->GetFocalPoint(description.FocalPoint.emplace().data());
  camera->GetViewUp(description.ViewUp.emplace().data());
  description.ViewAngle = camera->GetViewAngle();
  if (camera->GetParallelProjection())
  {
    description.ParallelScale = camera->GetParallelScale();
  }
  return description;
}

//------------------------------------------------------------------------------
void VolumeView::SetCamera(const CameraDescription& camera)
{
  ApplyCamera(camera, this->Rendering->GetRenderer()->GetActiveCamera());
  this->ScheduleFrame();
}

//------------------------------------------------------------------------------
ViewFrame VolumeView::GetFrame() const
{
  vtkCamera* camera = this->Rendering->GetRenderer()->GetActiveCamera();
  const CameraAxes axes(camera);
  ViewFrame frame{ {}, {}, axes.Right, axes.Up, axes.Backward };
  camera->GetPosition(frame.Position.data());
  camera->GetFocalPoint(frame.FocalPoint.data());
  return frame;
}

//------------------------------------------------------------------------------
std::array<int, 2> VolumeView::GetPictureSize() const
{
  const double ratio = this->devicePixelRatioF();
  return { qRound(this->width() * ratio), qRound(this->height() * ratio) };
}

//------------------------------------------------------------------------------
void VolumeView::ScheduleFrame()
{
  this->Refined = false;
  if (this->Rendering && !this->FrameTimer.isActive())
  {
    this->FrameTimer.start();
  }
}

//------------------------------------------------------------------------------
void VolumeView::paintGL()
{
  // Where the size has changed, Qt's widget draws itself by its interactor.
  this->SetRayDistance(this->FindMovingDistance());
  this->interactor()->EnableRenderOn();
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
}

//------------------------------------------------------------------------------
int VolumeView::FindMovingDistance()
{
  return this->Quality.FindDistance(this->interactor()->GetDesiredUpdateRate());
}

//------------------------------------------------------------------------------
void VolumeView::SetRayDistance(int distance)
{
  if (this->Rendering)
  {
    vtkGPUVolumeRayCastMapper::SafeDownCast(this->Rendering->GetVolume()->GetMapper())
      ->SetImageSampleDistance(static_cast<float>(distance));
  }
}

//------------------------------------------------------------------------------
void VolumeView::DrawMoving()
{
  const int distance = this->FindMovingDistance();
  this->Draw(distance);
  emit this->cameraMoved();
  if (distance > 1)
  {
    this->RefineTimer.start(StillMilliseconds);
  }
}

//------------------------------------------------------------------------------
void VolumeView::Refine()
{
  if (QApplication::mouseButtons() != Qt::NoButton)
  {
    this->RefineTimer.start(StillMilliseconds); // what is held still may yet move
    return;
  }
  this->Draw(this->FindStillDistance());
  if (!this->Refined)
  {
    this->RefineTimer.start(LongStillMilliseconds);
  }
}

//------------------------------------------------------------------------------
int VolumeView::FindStillDistance() const
{
  // Where a whole frame would hold the window up for long, one comes before that does not.
  if (this->SecondsOfLastWholeFrame <= LongestFrame)
  {
    return 1;
  }
  const int quick = this->Quality.FindDistance(1.0 / LongestQuickFrame);
  return quick < this->Distance ? quick : 1;
}

//------------------------------------------------------------------------------
bool VolumeView::event(QEvent* event)
{
  // VTK's interactor styles have keys of their own: stereo, wireframe, picking, the end.
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  return isKey ? QOpenGLWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
}

//------------------------------------------------------------------------------
void VolumeView::keyPressEvent(QKeyEvent* event)
{
  if (!this->Rendering)
  {
    QOpenGLWidget::keyPressEvent(event);
    return;
  }
  vtkCamera* camera = this->Rendering->GetRenderer()->GetActiveCamera();
  switch (event->key())
  {
    case Qt::Key_Left:
      camera->Azimuth(KeyDegrees);
      break;
    case Qt::Key_Right:
      camera->Azimuth(-KeyDegrees);
      break;
    case Qt::Key_Up:
      camera->Elevation(-KeyDegrees);
      break;
    case Qt::Key_Down:
      camera->Elevation(KeyDegrees);
      break;
    case Qt::Key_Plus:
      Zoom(camera, KeyZoom);
      break;
    case Qt::Key_Minus:
      Zoom(camera, 1.0 / KeyZoom);
      break;
    default:
      QOpenGLWidget::keyPressEvent(event);
      return;
  }
  camera->OrthogonalizeViewUp();
  this->ScheduleFrame();
}

//------------------------------------------------------------------------------
void VolumeView::mouseDoubleClickEvent(QMouseEvent* event)
{
  QVTKOpenGLNativeWidget::mouseDoubleClickEvent(event);
  if (!this->Rendering || event->button() != Qt::LeftButton)
  {
    return;
  }
  vtkRenderer* renderer = this->Rendering->GetRenderer();
  const QPointF place = event->localPos() * this->devicePixelRatioF();
  const double height = this->GetPictureSize()[1];
  const auto toWorld = [&](double depth)
  {
    double point[4];
    renderer->SetDisplayPoint(place.x(), height - 1.0 - place.y(), depth);
    renderer->DisplayToWorld();
    renderer->GetWorldPoint(point);
    return Vector3{ point[0] / point[3], point[1] / point[3], point[2] / point[3] };
  };
  const Vector3 near = toWorld(0.0);
  const auto target = FindSurface(this->Document->GetScene(), this->Document->GetVoxels().Volume,
    near, Difference(toWorld(1.0), near));
  if (target)
  {
    emit this->aimed(*target);
  }
}

//------------------------------------------------------------------------------
bool VolumeView::ShadowsChange() const
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
void VolumeView::Draw(int distance)
{
  if (!this->Rendering || !this->isValid())
  {
    return;
  }
  this->SetRayDistance(distance);
  this->Decorations->FitScaleBar();
  const auto before = std::chrono::steady_clock::now();
  // What is kept of shadows would have to be made anew for a frame that is soon outdated.
  auto* const mapper =
    distance > 1 && this->ShadowsChange() ? this->Rendering->GetIlluminatedMapper() : nullptr;
  const int technique = mapper ? mapper->GetShadowTechnique() : 0;
  if (mapper)
  {
    mapper->SetShadowTechniqueToRays();
  }
  this->Window->Render();
  this->Window->WaitForCompletion();
  if (mapper)
  {
    mapper->SetShadowTechnique(technique);
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  this->Quality.NoteFrame(passed.count(), distance);
  this->Distance = distance;
  this->Refined = distance == 1;
  if (this->Refined)
  {
    this->SecondsOfLastWholeFrame = passed.count();
    this->SceneChanged = false;
    this->RefineTimer.stop();
    this->TellWarnings();
    emit this->refined(passed.count());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> VolumeView::TakePicture()
{
  this->FrameTimer.stop();
  const bool orientation = this->Decorations->HasOrientation();
  const bool scaleBar = this->Decorations->HasScaleBar();
  this->Decorations->ShowOrientation(false);
  this->Decorations->ShowScaleBar(false);
  this->Overlay->Show(false);
  this->Draw(1);
  const auto picture = ReadPicture(this->Window);
  this->Decorations->ShowOrientation(orientation);
  this->Decorations->ShowScaleBar(scaleBar);
  this->Overlay->Show(true);
  this->ScheduleFrame();
  return picture;
}

//------------------------------------------------------------------------------
void VolumeView::TellWarnings()
{
  QStringList messages;
  for (const std::string& warning : this->Rendering->GetWarnings())
  {
    messages << QString::fromStdString(warning);
  }
  if (vtkIlluminatedVolumeMapper* mapper = this->Rendering->GetIlluminatedMapper())
  {
    for (const std::string& message : mapper->GetMessages())
    {
      messages << QString::fromStdString(message);
    }
  }
  emit this->warned(messages);
}

}
