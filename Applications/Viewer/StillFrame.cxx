#include "StillFrame.h"

#include <vtkCommand.h>
#include <vtkIlluminatedVolumeMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <chrono>

namespace penumbra
{

//------------------------------------------------------------------------------
StillFrame::~StillFrame()
{
  this->End();
}

//------------------------------------------------------------------------------
void StillFrame::Begin(vtkRenderer* renderer, vtkIlluminatedVolumeMapper* mapper, int strips)
{
  this->End();
  this->Renderer = renderer;
  this->Mapper = mapper;
  this->Strips = strips;
  this->Strip = 0;
  this->Seconds = 0.0;
  this->Mapper->SetShadowUpdateTime(SecondsOfShadows);
  this->Renderer->EraseOff(); // a strip is cleared when it is its turn
  // The camera has set its own scissor by then.
  this->Confining = mapper->AddObserver(
    vtkCommand::VolumeMapperRenderStartEvent, this, &StillFrame::ConfineToStrip);
  this->Freeing =
    mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this, &StillFrame::Free);
}

//------------------------------------------------------------------------------
void StillFrame::SetScissor(int below, int above)
{
  auto* const window = static_cast<vtkOpenGLRenderWindow*>(this->Renderer->GetRenderWindow());
  window->GetState()->vtkglScissor(0, below, this->Renderer->GetSize()[0], above - below);
}

//------------------------------------------------------------------------------
void StillFrame::ConfineToStrip()
{
  const int height = this->Renderer->GetSize()[1];
  this->SetScissor(height * this->Strip / this->Strips, height * (this->Strip + 1) / this->Strips);
  this->Renderer->Clear();
}

//------------------------------------------------------------------------------
void StillFrame::Free()
{
  this->SetScissor(0, this->Renderer->GetSize()[1]);
}

//------------------------------------------------------------------------------
bool StillFrame::DrawNext()
{
  const auto before = std::chrono::steady_clock::now();
  this->Renderer->GetRenderWindow()->Render();
  this->Renderer->GetRenderWindow()->WaitForCompletion();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  this->Seconds += passed.count();
  this->Strip += this->Mapper->GetShadowsComplete() ? 1 : 0;
  return this->Strip == this->Strips;
}

//------------------------------------------------------------------------------
void StillFrame::DrawOver()
{
  this->Strip = this->Strips; // beyond the window
  this->Renderer->GetRenderWindow()->Render();
}

//------------------------------------------------------------------------------
void StillFrame::End()
{
  if (this->Renderer)
  {
    this->Mapper->RemoveObserver(this->Confining);
    this->Mapper->RemoveObserver(this->Freeing);
    this->Mapper->SetShadowUpdateTime(0.0);
    this->Renderer->EraseOn();
    this->Renderer = nullptr;
    this->Mapper = nullptr;
  }
}

}
