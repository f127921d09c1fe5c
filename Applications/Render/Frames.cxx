#include "Frames.h"

#include "OffscreenWindow.h"
#include "Picture.h"
#include "Process.h"
#include "ProgressLine.h"
#include "RenderingError.h"
#include "SceneReference.h"
#include "SceneRendering.h"

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <chrono>

namespace penumbra
{
namespace
{
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
FrameDrawing DrawInWindow(vtkRenderWindow* window)
{
  if (!window->SupportsOpenGL())
  {
    throw RenderingError("there is no OpenGL 3.2 to render with");
  }
  const auto draw = [window]
  {
    window->Render();
    window->WaitForCompletion();
  };
  return { draw, [window] { return ReadPicture(window); }, NameOfOpenGLRenderer(window), nullptr };
}

//------------------------------------------------------------------------------
FrameDrawing DrawReference(
  const SceneDescription& scene, const SceneVoxels& voxels, SceneRendering& rendering)
{
  const auto picture = std::make_shared<vtkSmartPointer<vtkImageData>>();
  const auto statistics = std::make_shared<std::optional<ReferenceStatistics>>();
  const auto draw = [=, &scene, &voxels, &rendering]
  {
    ProgressLine line("integrating");
    ReferenceOptions options;
    options.Progress = [&line](double part)
    {
      line.Tell(part);
      return true;
    };
    const auto rendered =
      ReferenceIntegrator(MakeReferenceScene(scene, voxels, rendering), options).Render();
    *picture = rendered->Colors;
    *statistics = rendered->Statistics;
  };
  return { draw, [picture] { return *picture; }, "none, reference integrator", statistics };
}

//------------------------------------------------------------------------------
FrameTime TimeFrame(const FrameDrawing& drawing)
{
  const double cpuBefore = ProcessorSeconds();
  const auto before = std::chrono::steady_clock::now();
  drawing.Draw();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
  return { passed.count(), ProcessorSeconds() - cpuBefore };
}

//------------------------------------------------------------------------------
RenderedFrames RenderFrames(SceneRendering& rendering, const FrameDrawing& drawing,
  const RenderCommand& command, const std::function<void(int)>& afterEachFrame)
{
  RenderedFrames frames;
  frames.First = TimeFrame(drawing);
  frames.Picture = drawing.TakePicture();
  frames.OpenGLRenderer = drawing.Renderer;
  frames.Reference = drawing.Statistics ? *drawing.Statistics : std::nullopt;
  afterEachFrame(0);
  for (int frame = 1; frame <= command.NumberOfFrames; ++frame)
  {
    if (command.Change)
    {
      ChangeScene(rendering, *command.Change);
    }
    frames.Others.push_back(TimeFrame(drawing));
    afterEachFrame(frame);
  }
  return frames;
}

}
