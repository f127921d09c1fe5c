#include "Frames.h"

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Process.h"
#include "RenderingError.h"
#include "SceneRendering.h"

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <chrono>

namespace penumbra
{
namespace
{
FrameTime RenderFrame(vtkRenderWindow* window)
{
  const double cpuBefore = ProcessorSeconds();
  const auto before = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  return { passed.count(), ProcessorSeconds() - cpuBefore };
}

std::string NameOfOpenGLRenderer(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  const std::string label = "OpenGL renderer string:";
  const auto found = capabilities.find(label);
  if (found == std::string::npos)
  {
    return "unknown";
  }
  const auto begin = capabilities.find_first_not_of(' ', found + label.size());
  return capabilities.substr(begin, capabilities.find('\n', begin) - begin);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(
  SceneRendering& rendering, const std::array<int, 2>& size)
{
  UseOffscreenWindows();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(rendering.GetRenderer());
  return window;
}

//------------------------------------------------------------------------------
RenderedFrames RenderFrames(SceneRendering& rendering, vtkRenderWindow* window,
  const RenderCommand& command, const std::function<void(int)>& afterEachFrame)
{
  if (!window->SupportsOpenGL())
  {
    throw RenderingError("there is no OpenGL 3.2 to render with");
  }
  RenderedFrames frames;
  frames.First = RenderFrame(window);
  frames.Picture = ReadPicture(window);
  frames.OpenGLRenderer = NameOfOpenGLRenderer(window);
  afterEachFrame(0);
  for (int frame = 1; frame <= command.NumberOfFrames; ++frame)
  {
    if (command.Change)
    {
      ChangeScene(rendering, *command.Change);
    }
    frames.Others.push_back(RenderFrame(window));
    afterEachFrame(frame);
  }
  return frames;
}

}
