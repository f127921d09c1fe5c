#include "OffscreenView.h"

#include "Picture.h"
#include "RenderingError.h"
#include "SceneRendering.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace penumbra
{

//------------------------------------------------------------------------------
OffscreenView::OffscreenView()
{
  this->Context.setFormat(QSurfaceFormat::defaultFormat());
  this->Surface.setFormat(QSurfaceFormat::defaultFormat());
  this->Surface.create();
  if (!this->Context.create() || !this->Context.makeCurrent(&this->Surface))
  {
    throw RenderingError("there is no OpenGL to draw pictures with");
  }
  this->Window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &OffscreenView::MakeCurrent);
  this->Window->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &OffscreenView::TellIsCurrent);
  this->Window->SetOwnContext(0);
  this->Window->SetReadyForRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetFrameBlitModeToNoBlit();
  this->Window->OpenGLInitContext();
}

//------------------------------------------------------------------------------
OffscreenView::~OffscreenView()
{
  this->SetRendering(nullptr);
  this->MakeCurrent();
  this->Window->Finalize();
  this->Context.doneCurrent();
}

//------------------------------------------------------------------------------
void OffscreenView::MakeCurrent()
{
  this->Context.makeCurrent(&this->Surface);
}

//------------------------------------------------------------------------------
void OffscreenView::TellIsCurrent(vtkObject*, unsigned long, void* answer)
{
  *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == &this->Context;
}

//------------------------------------------------------------------------------
void OffscreenView::SetRendering(SceneRendering* rendering)
{
  this->MakeCurrent();
  while (vtkRenderer* renderer = this->Window->GetRenderers()->GetFirstRenderer())
  {
    this->Window->RemoveRenderer(renderer);
  }
  if (rendering)
  {
    this->Window->AddRenderer(rendering->GetRenderer());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> OffscreenView::TakePicture(const std::array<int, 2>& size)
{
  this->MakeCurrent();
  this->Window->SetSize(size[0], size[1]);
  this->Window->Render();
  return ReadPicture(this->Window);
}

}
