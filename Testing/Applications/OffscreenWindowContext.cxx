#include "Catch.h"
#include "RenderToImage.h"

#include <vtkOffscreenWindow.h>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace
{
/// Windows that are made while this lives get no context.
struct NoContexts
{
  NoContexts()
  {
    vtkOffscreenWindow::SetContextMaker([]() -> std::unique_ptr<penumbra::OffscreenContext>
      { throw std::runtime_error("out of contexts"); });
  }
  ~NoContexts() { vtkOffscreenWindow::SetContextMaker(this->Usual); }

  const penumbra::OffscreenContextMaker Usual = vtkOffscreenWindow::GetContextMaker();
};
}

TEST_CASE("A window without a context says so once and does nothing")
{
  const NoContexts scope;
  vtkNew<vtkOffscreenWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  std::vector<std::string> errors;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&errors);
  listener->SetCallback([](vtkObject*, unsigned long, void* heard, void* text)
    { static_cast<std::vector<std::string>*>(heard)->emplace_back(static_cast<char*>(text)); });
  window->AddObserver(vtkCommand::ErrorEvent, listener);

  CHECK_FALSE(window->SupportsOpenGL());
  window->Render();
  window->SetSize(20, 30);
  window->Render();
  CHECK(std::string(window->ReportCapabilities()).empty());
  CHECK_THROWS_AS(penumbra::RenderToImage(window), std::runtime_error);
  window->Finalize();
  REQUIRE(errors.size() == 1);
  CHECK_THAT(errors[0], Catch::Matchers::ContainsSubstring("out of contexts"));
}

TEST_CASE("Reading the pixels of a window without a context reads nothing")
{
  const NoContexts scope;
  vtkNew<vtkOffscreenWindow> window;
  window->SetGlobalWarningDisplay(false);
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->Update();
  window->SetGlobalWarningDisplay(true);
  CHECK_FALSE(window->IsCurrent());
}

TEST_CASE("A window has a context from its first picture until it is finalized")
{
  vtkNew<vtkOffscreenWindow> window;
  CHECK_FALSE(window->IsCurrent());
  window->Render();
  CHECK(window->IsCurrent());
  window->Finalize();
  CHECK_FALSE(window->IsCurrent());
}
