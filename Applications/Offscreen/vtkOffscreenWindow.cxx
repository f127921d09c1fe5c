#include "vtkOffscreenWindow.h"

#include "GLXFunctions.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkObjectFactory.h>

#include <stdexcept>

vtkStandardNewMacro(vtkOffscreenWindow);

namespace
{
penumbra::OffscreenContextMaker currentMaker = nullptr;
}

//------------------------------------------------------------------------------
vtkOffscreenWindow::vtkOffscreenWindow()
  : ContextMaker(currentMaker)
{
  this->Size[0] = this->Size[1] = 300;
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  this->SetFrameBlitModeToNoBlit();
}

//------------------------------------------------------------------------------
vtkOffscreenWindow::~vtkOffscreenWindow()
{
  this->vtkOffscreenWindow::Finalize();
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Context ? "made" : "none") << "\n";
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::SetContextMaker(penumbra::OffscreenContextMaker maker)
{
  currentMaker = maker;
}

//------------------------------------------------------------------------------
penumbra::OffscreenContextMaker vtkOffscreenWindow::GetContextMaker()
{
  return currentMaker;
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::MakeContext()
{
  // Mesa compiles its shaders with LLVM, which does not survive trapped floating-point exceptions.
  vtkFloatingPointExceptions::Disable();
  try
  {
    if (!this->ContextMaker)
    {
      throw std::runtime_error("no kind of context was chosen");
    }
    this->Context = this->ContextMaker();
  }
  catch (const std::runtime_error& error)
  {
    this->SetReadyForRendering(false);
    vtkErrorMacro("No OpenGL context: " << error.what());
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::MakeCurrent()
{
  if (!this->Context && this->ReadyForRendering)
  {
    this->MakeContext();
  }
  if (this->Context && !this->Context->IsCurrent() && !this->Context->MakeCurrent())
  {
    this->SetReadyForRendering(false);
    vtkErrorMacro("The OpenGL context cannot be made current.");
  }
}

//------------------------------------------------------------------------------
bool vtkOffscreenWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::Initialize()
{
  this->MakeCurrent();
  if (this->IsCurrent() && !this->Initialized)
  {
    this->OpenGLInit();
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::OpenGLInitContext()
{
  const penumbra::OpenGLFunctionsFrom scope(*this->Context);
  this->Superclass::OpenGLInitContext();
  this->SetReadyForRendering(this->Initialized);
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::Render()
{
  this->Initialize();
  this->Superclass::Render();
}

//------------------------------------------------------------------------------
void vtkOffscreenWindow::Finalize()
{
  if (this->Context)
  {
    this->MakeCurrent();
    this->Superclass::Finalize();
    this->Context.reset();
  }
}

//------------------------------------------------------------------------------
int vtkOffscreenWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Initialized ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkOffscreenWindow::IsDirect()
{
  return 0;
}

//------------------------------------------------------------------------------
const char* vtkOffscreenWindow::ReportCapabilities()
{
  return this->SupportsOpenGL() ? this->Superclass::ReportCapabilities() : "";
}
