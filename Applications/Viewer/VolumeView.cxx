#include "VolumeView.h"

#include "CameraKeys.h"
#include "SceneCamera.h"
#include "SceneDocument.h"
#include "SceneRendering.h"
#include "SurfacePicking.h"
#include "ViewDecorations.h"
#include "ViewOverlay.h"
#include "VolumeFields.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

namespace penumbra
{
namespace
{
// Frames a second while something moves.
constexpr double FluidRate = 10.0;
}

//------------------------------------------------------------------------------
VolumeView::VolumeView(SceneDocument* document, QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , Document(document)
  , Drawing(this, document)
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
  this->Drawing.SetOver(this->Decorations.get(), this->Overlay.get());
  this->connect(&this->Drawing, &ViewDrawing::moved, this, &VolumeView::cameraMoved);
  this->connect(&this->Drawing, &ViewDrawing::refined, this,
    [this](double seconds)
    {
      this->TellWarnings();
      emit this->refined(seconds);
    });
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
    this->Drawing.SetRendering(nullptr);
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
  this->Rendering->GetVolume()->SetVisibility(this->VolumeShown);
  this->AttachDecorations();
  this->Drawing.SetRendering(this->Rendering.get());
}

//------------------------------------------------------------------------------
void VolumeView::ShowVolume(bool shown)
{
  this->VolumeShown = shown;
  if (this->Rendering)
  {
    this->Rendering->GetVolume()->SetVisibility(shown);
    this->ScheduleFrame();
  }
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
  this->Drawing.Schedule(true);
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
  this->Drawing.Schedule(false);
}

//------------------------------------------------------------------------------
void VolumeView::paintGL()
{
  // Where the size has changed, Qt's widget draws itself by its interactor.
  this->interactor()->EnableRenderOn();
  this->Drawing.DrawBy([this] { QVTKOpenGLNativeWidget::paintGL(); });
  this->interactor()->EnableRenderOff();
}

//------------------------------------------------------------------------------
bool VolumeView::event(QEvent* event)
{
  // VTK's interactor styles have keys of their own: stereo, wireframe, picking, the end.
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  return isKey ? QOpenGLWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
}

//------------------------------------------------------------------------------
void VolumeView::resizeGL(int width, int height)
{
  QVTKOpenGLNativeWidget::resizeGL(width, height);
  this->Drawing.Schedule(false);
}

//------------------------------------------------------------------------------
void VolumeView::keyPressEvent(QKeyEvent* event)
{
  if (this->Rendering && MoveByKey(event->key(), this->Rendering->GetRenderer()->GetActiveCamera()))
  {
    this->ScheduleFrame();
    return;
  }
  QOpenGLWidget::keyPressEvent(event);
}

//------------------------------------------------------------------------------
void VolumeView::mouseDoubleClickEvent(QMouseEvent* event)
{
  QVTKOpenGLNativeWidget::mouseDoubleClickEvent(event);
  if (!this->Rendering || event->button() != Qt::LeftButton)
  {
    return;
  }
  const QPointF place = event->localPos() * this->devicePixelRatioF();
  const auto target = FindSurfaceAt(this->Document->GetScene(), this->Document->GetVoxels().Volume,
    this->Rendering->GetRenderer(), { place.x(), this->GetPictureSize()[1] - 1.0 - place.y() });
  if (target)
  {
    emit this->aimed(*target);
  }
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
